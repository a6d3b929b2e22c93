package mmneat.experiment;

import java.util.stream.IntStream;

/** The check that a text is one printable line: it becomes a file's name, a line of a job file or a value in a file. */
public final class PlainText {

    private PlainText() {}

    /**
     * Makes sure that a text has no control characters and no halves of characters.
     *
     * @param what what the text is, for the message
     * @throws UserError naming the first such character; the message shows the text without them
     */
    public static void require(String what, String text) {
        IntStream.range(0, text.length())
                .filter(i -> !isPlain(text, i))
                .findFirst()
                .ifPresent(i -> {
                    throw new UserError(String.format(
                            "%s: must not contain control characters, has U+%04X at place %d: %s",
                            shown(what), (int) text.charAt(i), i + 1, shown(text)));
                });
    }

    /** The text without the blanks and tabs before and behind it. */
    public static String trimmed(String text) {
        return text.replaceAll("^[ \t]+|[ \t]+$", "");
    }

    /** The text on one line, with a question mark for each character that is neither plain nor a tab. */
    public static String shown(String text) {
        StringBuilder shown = new StringBuilder(text);
        IntStream.range(0, text.length())
                .filter(i -> !isPlain(text, i) && text.charAt(i) != '\t')
                .forEach(i -> shown.setCharAt(i, '?'));
        return shown.toString();
    }

    /** Line and paragraph separators end lines in some readers. */
    private static boolean isPlain(String text, int i) {
        char c = text.charAt(i);
        boolean isHalf = Character.isHighSurrogate(c)
                ? i + 1 == text.length() || !Character.isLowSurrogate(text.charAt(i + 1))
                : Character.isLowSurrogate(c) && (i == 0 || !Character.isHighSurrogate(text.charAt(i - 1)));
        return !isHalf && !Character.isISOControl(c) && c != '\u2028' && c != '\u2029';
    }
}
