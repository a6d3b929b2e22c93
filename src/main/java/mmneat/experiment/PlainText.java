package mmneat.experiment;

import java.util.stream.IntStream;
import mmneat.neat.OneLine;
import mmneat.neat.Thrown;
import org.jspecify.annotations.Nullable;

/**
 * The check that a text is one printable line, before it is used as a file name, a line of a job file or a value in a
 * file.
 */
public final class PlainText {

    private PlainText() {}

    /**
     * Checks that a text has no control characters and no unpaired surrogates.
     *
     * @param what what the text is, for the message
     * @throws UserError naming the first such character; the message shows the text without them
     */
    public static void require(String what, String text) {
        IntStream.range(0, text.length())
                .filter(i -> !OneLine.isPlain(text, i))
                .findFirst()
                .ifPresent(i -> {
                    throw new UserError(String.format(
                            "%s: must not contain control characters, has U+%04X at position %d: %s",
                            shown(what), (int) text.charAt(i), i + 1, shown(text)));
                });
    }

    /** Returns the text without leading and trailing blanks and tabs. */
    public static String trimmed(String text) {
        return text.replaceAll("^[ \t]+|[ \t]+$", "");
    }

    /** Returns the text on one line, with a question mark for each character that is neither printable nor a tab. */
    public static String shown(String text) {
        return OneLine.of(text);
    }

    /**
     * Returns the class and the message of an exception that foreign code threw (the user's own classes or a contest's
     * entry), made printable by {@link #shown(String)}. If {@code toString} of the exception fails itself, the result
     * is the name of the class alone.
     */
    public static String shown(@Nullable Throwable thrown) {
        return thrown == null ? "null" : new Thrown(thrown).line();
    }
}
