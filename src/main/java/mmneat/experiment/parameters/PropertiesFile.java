package mmneat.experiment.parameters;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import mmneat.experiment.FileErrors;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;

/** Files of parameters: a line {@code name=value}, or the original's {@code name:value}, for each. */
public final class PropertiesFile {

    /** The first sign or, if there is none, the first blank. */
    private static final Pattern END_OF_NAME = Pattern.compile("[=:]|[ \t](?=[^=:]*$)");

    private PropertiesFile() {}

    /**
     * All values by name.
     *
     * @throws UserError if the file cannot be read, or a name stands there twice
     */
    public static Map<String, String> read(Path file) {
        try {
            return read(Files.readString(file));
        } catch (IOException e) {
            throw new UserError(file + ": cannot be read: " + FileErrors.reason(e), e);
        } catch (UserError e) {
            throw new UserError(file + ": " + e.getMessage(), e);
        }
    }

    /**
     * The values of a text: on each line a name, {@code =} or {@code :} or a blank, and the value, which is everything behind it
     * without the blanks and tabs around. Empty lines and lines that begin with {@code #} or {@code !} say nothing.
     *
     * <p>A backslash stands for itself, so that names of Windows files need no care; only a single one at the very end of a line
     * joins it to the next.
     *
     * @throws UserError if a name stands there twice
     */
    static Map<String, String> read(String text) {
        Map<String, String> values = new TreeMap<>();
        for (String line : joined(text.replaceFirst("^\uFEFF", "").lines().toList())) {
            Matcher end = END_OF_NAME.matcher(line);
            int sign = end.find() ? end.start() : line.length();
            String name = PlainText.trimmed(line.substring(0, sign));
            String value = line.substring(Math.min(line.length(), sign + 1));
            if (values.put(name, PlainText.trimmed(value)) != null) {
                throw new UserError("'" + name + "' is given twice; give it once");
            }
        }
        return values;
    }

    /** The lines that say something, those that a backslash joins as one. */
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
     * The text that {@link #read(String)} reads as these values.
     *
     * @param values plain texts without blanks around them
     * @param comment a line that stands first
     */
    public static String write(Map<String, String> values, String comment) {
        StringBuilder text = new StringBuilder("# " + comment + "\n");
        values.forEach((name, value) -> {
            text.append(name).append('=').append(value);
            // A blank keeps the backslash from joining this line to the next.
            text.append(value.endsWith("\\") ? " \n" : "\n");
        });
        return text.toString();
    }

    /**
     * Makes sure that a value is a whole number, as far as there is one.
     *
     * @param file where the values are from, for the message
     * @throws UserError if it is none
     */
    public static void requireWholeNumber(Path file, Map<String, String> values, String name) {
        try {
            Integer.parseInt(values.getOrDefault(name, "0"));
        } catch (NumberFormatException e) {
            throw new UserError(file + ": " + name + "=" + values.get(name) + ": must be a whole number", e);
        }
    }

    /** The same for any number. */
    public static void requireNumber(Path file, Map<String, String> values, String name) {
        try {
            Double.parseDouble(values.getOrDefault(name, "0"));
        } catch (NumberFormatException e) {
            throw new UserError(file + ": " + name + "=" + values.get(name) + ": must be a number", e);
        }
    }
}
