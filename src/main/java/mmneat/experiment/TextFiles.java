package mmneat.experiment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Reader of text files in UTF-8, whose failures are errors of the user. */
public final class TextFiles {

    private TextFiles() {}

    /**
     * Returns the lines of a file.
     *
     * @throws UserError if it cannot be read
     */
    public static List<String> lines(Path file) {
        try {
            return Files.readAllLines(file, StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw FileErrors.unreadable(file, e);
        }
    }
}
