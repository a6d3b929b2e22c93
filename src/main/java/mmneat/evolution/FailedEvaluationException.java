package mmneat.evolution;

/**
 * Thrown when a task throws an exception during an evaluation. The message says which genotype, when, and what the task
 * threw.
 */
public final class FailedEvaluationException extends IllegalStateException {
    private static final long serialVersionUID = 1;

    /** @param where the genotype and generation, or the trial */
    public FailedEvaluationException(String where, Throwable cause) {
        super(where + (cause instanceof FailedEvaluationException ? ", " + cause.getMessage() : ": " + cause), cause);
    }

    /** Returns what the task threw. */
    public Throwable thrown() {
        return getCause() instanceof FailedEvaluationException inner ? inner.thrown() : getCause();
    }
}
