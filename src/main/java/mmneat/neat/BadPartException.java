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
        super(part + ": " + problem);
    }

    /** The part threw an exception; the message says where. */
    public BadPartException(String part, Throwable thrown) {
        super(part + ": threw " + thrown + place(thrown), thrown);
    }

    private static String place(Throwable thrown) {
        StackTraceElement[] trace = thrown.getStackTrace();
        return trace.length == 0 ? "" : " at " + trace[0];
    }

    /** Returns the exception of this type among a failure and its causes; empty if there is none. */
    public static Optional<BadPartException> in(Throwable failure) {
        for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
            if (cause instanceof BadPartException bad) {
                return Optional.of(bad);
            }
        }
        return Optional.empty();
    }
}
