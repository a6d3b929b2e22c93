package mmneat.evolution;

/** A task threw an exception while it evaluated a genotype. The message says which genotype, when, and what was thrown. */
public final class FailedEvaluationException extends IllegalStateException {
    private static final long serialVersionUID = 1;

    /** @param where the genotype and generation, or the trial */
    public FailedEvaluationException(String where, Throwable cause) {
        super(where + (cause instanceof FailedEvaluationException ? ", " + cause.getMessage() : ": " + cause), cause);
    }

    /** What the task threw. */
    public Throwable thrown() {
        return getCause() instanceof FailedEvaluationException inner ? inner.thrown() : getCause();
    }
}
