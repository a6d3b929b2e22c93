package mmneat.evolution;

/** A task broke its promises: what it says of a genotype is no evaluation. The message says whose, and what is wrong. */
public final class BadEvaluationException extends RuntimeException {
    private static final long serialVersionUID = 1;

    BadEvaluationException(String message) {
        super(message);
    }
}
