package mmneat.experiment;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Converter of file exceptions to messages for the user. Java's own messages are not enough: that of most file
 * exceptions is only the name of the file.
 */
public final class FileErrors {

    /** The message of a {@link FileNotFoundException} is the file and the operating system's message. */
    private static final Pattern REASON_IN_PARENTHESES = Pattern.compile(" \\(([^()]+)\\)$");

    private FileErrors() {}

    /**
     * Returns the reason alone, for example "permission denied". For callers that have put the name of the file into
     * the message themselves.
     */
    public static String reason(IOException e) {
        if (e instanceof NoSuchFileException) {
            return "there is no such file";
        }
        if (e instanceof AccessDeniedException) {
            return "permission denied";
        }
        if (e instanceof FileNotFoundException && e.getMessage() != null) {
            Matcher reason = REASON_IN_PARENTHESES.matcher(e.getMessage());
            return reason.find() ? ofOperatingSystem(reason.group(1)) : "there is no such file";
        }
        if (e instanceof FileAlreadyExistsException existing) {
            return existing.getFile() + " exists and is not a folder";
        }
        if (e instanceof CharacterCodingException) {
            return "it is not a text in UTF-8";
        }
        if (e instanceof FileSystemException failure && failure.getReason() != null) {
            return failure.getReason();
        }
        if (e.getClass() == IOException.class && e.getMessage() != null) {
            return ofOperatingSystem(e.getMessage());
        }
        return e.getClass().getSimpleName() + ": " + e.getMessage();
    }

    /** Returns the operating system's message, such as "No space left on device", with frequent ones as sentences. */
    private static String ofOperatingSystem(String message) {
        return switch (message) {
            case "Is a directory" -> "it is a folder; name a file in it";
            case "Permission denied" -> "permission denied";
            case "No such file or directory" -> "there is no such file";
            default -> message;
        };
    }

    /**
     * Returns the error "FILE: cannot be read: REASON".
     *
     * @param file the file, or the word of the command line that names it, such as {@code maze=FILE}
     */
    public static UserError unreadable(Object file, IOException e) {
        return new UserError(file + ": cannot be read: " + reason(e), e);
    }

    /**
     * Returns the error "FILE: cannot be written: REASON".
     *
     * @param file the file
     */
    public static UserError unwritable(Object file, IOException e) {
        return new UserError(file + ": cannot be written: " + reason(e), e);
    }

    /**
     * Returns the text "FILE: REASON", or the reason alone if the exception does not know the file. For callers that do
     * not know which file failed.
     */
    public static String sentence(IOException e) {
        return e instanceof FileSystemException failure && failure.getFile() != null
                ? failure.getFile() + ": " + reason(e)
                : reason(e);
    }
}
