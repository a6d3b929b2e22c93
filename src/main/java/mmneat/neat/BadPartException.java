package mmneat.neat;

import java.util.Optional;

/**
 * Thrown when a part of the user's own, such as an activation function or a mutation operator, returns something
 * invalid or throws an exception. The message names the part and says in one line what is wrong.
 */
public final class BadPartException extends IllegalStateException {
    private static final long serialVersionUID = 1;

    /** @param part the kind of part and its class, for example {@code "activation function my.Sine"} */
    public BadPartException(String part, String problem) {
        super(OneLine.of(part + ": " + problem));
    }

    /** The part threw an exception; the message says where. */
    public BadPartException(String part, Throwable thrown) {
        super(OneLine.of(part) + ": threw " + new Thrown(thrown).line() + new Thrown(thrown).place(), thrown);
    }

    /** Returns the exception of this type among a failure and its causes; empty if there is none. */
    public static Optional<BadPartException> in(Throwable failure) {
        return new Thrown(failure)
                .causes().stream()
                        .filter(BadPartException.class::isInstance)
                        .map(BadPartException.class::cast)
                        .findFirst();
    }
}
