package mmneat.evolution;

import java.util.Objects;
import mmneat.neat.BadPartException;
import mmneat.neat.Thrown;

/**
 * Thrown when a task throws an exception during an evaluation. The message says which genotype, when, and what the task
 * threw.
 */
public final class FailedEvaluationException extends IllegalStateException {
    private static final long serialVersionUID = 1;

    /** @param where the genotype and generation, or the trial */
    public FailedEvaluationException(String where, Throwable cause) {
        super(where + described(cause), cause);
    }

    private static String described(Throwable cause) {
        if (cause instanceof FailedEvaluationException) {
            return ", " + cause.getMessage();
        }
        return ": " + (cause instanceof BadPartException ? cause.getMessage() : new Thrown(cause).line());
    }

    /** Returns what the task threw. */
    public Throwable thrown() {
        Throwable cause = Objects.requireNonNull(getCause(), "every failure has a cause");
        return cause instanceof FailedEvaluationException inner ? inner.thrown() : cause;
    }
}
