package mmneat.experiment.parameters;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import mmneat.experiment.FileErrors;
import mmneat.experiment.PlainText;
import mmneat.experiment.TextFiles;
import mmneat.experiment.UserError;

/**
 * Reads and writes files of parameters: one line {@code name=value}, or the original's {@code name:value}, per
 * parameter.
 */
public final class PropertiesFile {

    /** The first separator or, if there is none, the first blank. */
    private static final Pattern END_OF_NAME = Pattern.compile("[=:]|[ \t](?=[^=:]*$)");

    /** The names of parameters, for messages; other names are refused by those that know all of them. */
    private static final Pattern NAME = Pattern.compile("[\\w.]+");

    private PropertiesFile() {}

    /**
     * All values by name.
     *
     * @throws UserError if the file cannot be read, or a name occurs twice
     */
    public static Map<String, String> read(Path file) {
        try {
            return read(TextFiles.text(file, TextFiles.SETTINGS_MIB));
        } catch (IOException e) {
            throw FileErrors.unreadable(file, e);
        } catch (UserError e) {
            throw new UserError(file + ": " + e.getMessage(), e);
        }
    }

    /**
     * Reads the values of a text. Each line has a name, {@code =} or {@code :} or a blank, and the value: the rest of
     * the line without leading and trailing blanks and tabs. Empty lines and lines that start with {@code #} or {@code
     * !} are ignored.
     *
     * <p>A backslash is an ordinary character, so Windows file names need no escapes. Only a single backslash at the
     * end of a line joins it to the next.
     *
     * @throws UserError if a name occurs twice
     */
    static Map<String, String> read(String text) {
        Map<String, String> values = new TreeMap<>();
        for (String line : joined(text.replaceFirst("^\uFEFF", "").lines().toList())) {
            Matcher end = END_OF_NAME.matcher(line);
            int sign = end.find() ? end.start() : line.length();
            String name = PlainText.trimmed(line.substring(0, sign));
            String value = line.substring(Math.min(line.length(), sign + 1));
            if (values.put(name, PlainText.trimmed(value)) != null) {
                throw new UserError(
                        NAME.matcher(name).matches()
                                ? "'" + name + "' is given twice; give it once"
                                : "is not a file of parameters, one name=value per line: a line begins with '" + name
                                        + "'");
            }
        }
        return values;
    }

    /** Returns the lines that are not ignored, with continued lines joined. */
    private static List<String> joined(List<String> lines) {
        List<String> joined = new ArrayList<>();
        String begun = "";
        for (String line : lines) {
            String trimmed = begun + line.replaceFirst("^[ \t\f]+", "");
            boolean saysNothing = begun.isEmpty() && (trimmed.isEmpty() || trimmed.matches("[#!].*"));
            boolean goesOn = !saysNothing && trimmed.matches("(|.*[^\\\\])\\\\");
            begun = goesOn ? trimmed.substring(0, trimmed.length() - 1) : "";
            if (!goesOn && !saysNothing) {
                joined.add(trimmed);
            }
        }
        if (!begun.isEmpty()) {
            joined.add(begun);
        }
        return joined;
    }

    /**
     * Returns a text that {@link #read(String)} reads as these values.
     *
     * @param values printable texts without leading or trailing blanks
     * @param comment the first line
     */
    public static String write(Map<String, String> values, String comment) {
        StringBuilder text = new StringBuilder("# " + comment + "\n");
        values.forEach((name, value) -> {
            text.append(name).append('=').append(value);
            // The blank prevents the backslash from joining this line to the next.
            text.append(value.endsWith("\\") ? " \n" : "\n");
        });
        return text.toString();
    }

    /**
     * Checks that a value, if there is one, is a whole number.
     *
     * @param file the file with the values, for the message
     * @throws UserError if it is none
     */
    public static void requireWholeNumber(Path file, Map<String, String> values, String name) {
        try {
            Integer.parseInt(values.getOrDefault(name, "0"));
        } catch (NumberFormatException e) {
            throw new UserError(file + ": " + name + "=" + values.get(name) + ": must be a whole number", e);
        }
    }

    /** Checks that a value, if there is one, is a number. */
    public static void requireNumber(Path file, Map<String, String> values, String name) {
        try {
            Double.parseDouble(values.getOrDefault(name, "0"));
        } catch (NumberFormatException e) {
            throw new UserError(file + ": " + name + "=" + values.get(name) + ": must be a number", e);
        }
    }
}
