package mmneat.experiment;

import org.jspecify.annotations.Nullable;

/**
 * An error of the user, reported in one line: what is wrong, where, and what to do.
 *
 * <p>The command line prints only the message, without a stack trace, and exits with code 2. Any other exception that
 * reaches it is a bug of the program or of a class of the user's own: it prints a stack trace and exits with code 1.
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
    public UserError(@Nullable String message, Throwable cause) {
        super(message, cause);
    }
}
