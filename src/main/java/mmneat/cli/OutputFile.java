package mmneat.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import mmneat.experiment.FileTrouble;
import mmneat.experiment.UserError;

/** Files that a user asked a command to write. */
final class OutputFile {

    private OutputFile() {}

    /** Writes a text, making the folders on the way. */
    static void write(Path file, String text) {
        write(file, text.getBytes(StandardCharsets.UTF_8));
    }

    /** Writes bytes, making the folders on the way. */
    static void write(Path file, byte[] content) {
        try {
            Path folder = file.toAbsolutePath().getParent();
            if (folder != null) {
                Files.createDirectories(folder);
            }
            Files.write(file, content);
        } catch (IOException e) {
            throw new UserError(file + ": cannot be written: " + FileTrouble.reason(e), e);
        }
    }
}
