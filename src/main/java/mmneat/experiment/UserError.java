package mmneat.experiment;

/**
 * A mistake of the user, told in one line: what is wrong, where, and what to do.
 *
 * <p>The command line prints the message alone, without a stack trace, and exits with code 2. Anything else that reaches
 * it is a failure of ours: a stack trace and exit code 1.
 */
public final class UserError extends RuntimeException {

    /** @param message one line, without a full stop at the end */
    public UserError(String message) {
        super(message);
    }

    /**
     * @param message one line, without a full stop at the end
     * @param cause kept for debugging; it is not shown to the user
     */
    public UserError(String message, Throwable cause) {
        super(message, cause);
    }
}
