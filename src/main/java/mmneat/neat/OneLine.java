package mmneat.neat;

import java.util.stream.IntStream;

/** The form of a text in a message of one line: without control characters and unpaired surrogates. */
public final class OneLine {

    private OneLine() {}

    /** Returns the text with a question mark for each character that is neither printable nor a tab. */
    public static String of(String text) {
        StringBuilder line = new StringBuilder(text);
        IntStream.range(0, text.length())
                .filter(i -> !isPlain(text, i) && text.charAt(i) != '\t')
                .forEach(i -> line.setCharAt(i, '?'));
        return line.toString();
    }

    /**
     * Whether the character at an index is printable: neither a control character nor half of a surrogate pair. Line
     * and paragraph separators are not printable here, because several programs treat them as line ends.
     */
    public static boolean isPlain(String text, int i) {
        char c = text.charAt(i);
        boolean isHalf = Character.isHighSurrogate(c)
                ? i + 1 == text.length() || !Character.isLowSurrogate(text.charAt(i + 1))
                : Character.isLowSurrogate(c) && (i == 0 || !Character.isHighSurrogate(text.charAt(i - 1)));
        return !isHalf && !Character.isISOControl(c) && c != '\u2028' && c != '\u2029';
    }
}
