package mmneat.neat;

import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * A part of the user's own, for messages about it: its calls go through this object, which turns whatever they throw
 * into a {@link BadPartException} of one line.
 *
 * @param description the kind of part and its class, for example {@code "selection my.Selection"}
 */
public record OwnPart(String description) {

    /** @param kind for example {@code "selection"} */
    public static OwnPart of(String kind, Object part) {
        return new OwnPart(kind + " " + part.getClass().getName());
    }

    /**
     * Calls a method of the part.
     *
     * @throws BadPartException if the call throws anything, checked exceptions included; errors of the Java virtual
     *     machine, such as exhausted memory, pass
     */
    public <T extends @Nullable Object> T call(Supplier<T> method) {
        try {
            return method.get();
        } catch (BadPartException e) {
            throw e;
        } catch (Throwable e) {
            new Thrown(e).passOnIfOfTheMachine();
            throw new BadPartException(description, e);
        }
    }

    /**
     * Calls a method of the part that returns a number.
     *
     * @throws BadPartException if the call throws an exception or the number is not finite
     */
    public double number(DoubleSupplier method) {
        double number = call(method::getAsDouble);
        if (!Double.isFinite(number)) {
            throw bad("gave " + number + "; it must give a finite number");
        }
        return number;
    }

    /** The exception that says what is wrong with the part. */
    public BadPartException bad(String problem) {
        return new BadPartException(description, problem);
    }
}
