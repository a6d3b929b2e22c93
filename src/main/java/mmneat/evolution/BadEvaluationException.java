package mmneat.evolution;

/** Thrown when a task returns an invalid evaluation. The message names the task and says what is wrong. */
public final class BadEvaluationException extends RuntimeException {
    private static final long serialVersionUID = 1;

    BadEvaluationException(String message) {
        super(message);
    }
}
