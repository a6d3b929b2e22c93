package mmneat.experiment.parameters;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import mmneat.experiment.FileErrors;
import mmneat.experiment.UserError;

/** Reads parameters in Java's properties syntax, which takes {@code name=value} and the original's {@code name:value}. */
public final class PropertiesFile {

    private PropertiesFile() {}

    /**
     * All values by name.
     *
     * @throws UserError if the file cannot be read, or a name stands there twice
     */
    public static Map<String, String> read(Path file) {
        try (Reader reader = Files.newBufferedReader(file)) {
            return read(reader);
        } catch (IOException e) {
            throw new UserError(file + ": cannot be read: " + FileErrors.reason(e), e);
        } catch (UserError e) {
            throw new UserError(file + ": " + e.getMessage(), e);
        }
    }

    /** The same; names are taken whole, dots included. */
    static Map<String, String> read(Reader reader) throws IOException {
        Map<String, String> values = new TreeMap<>();
        new Properties() {
            private static final long serialVersionUID = 1;

            @Override
            public synchronized Object put(Object name, Object value) {
                if (values.put((String) name, (String) value) != null) {
                    throw new UserError("'" + name + "' is given twice; give it once");
                }
                return null;
            }
        }.load(reader);
        return values;
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
