package mmneat.cli.output;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import mmneat.experiment.FileErrors;
import mmneat.experiment.FolderPlace;
import mmneat.experiment.UserError;
import mmneat.experiment.store.DurableFiles;

/** Writes files that the user named. */
public final class OutputFile {

    private OutputFile() {}

    /**
     * Checks that a file can be written, before a long computation.
     *
     * @param word the option with this file, for messages
     */
    public static void require(String word, Path file) {
        if (Files.isDirectory(file)) {
            throw new UserError(word + "=" + file + ": this is a folder; name a file in it");
        }
        Path place = FolderPlace.existing(file.toAbsolutePath().getParent());
        if (place != null && !(Files.isDirectory(place) && Files.isWritable(place))
                || Files.exists(file) && !Files.isWritable(file)) {
            throw new UserError(word + "=" + file + ": cannot be written; name another place");
        }
    }

    /**
     * Checks that files can be written into a folder, before a long computation. It may be missing.
     *
     * @param word the option with this folder, for messages
     */
    public static void requireFolder(String word, Path folder) {
        FolderPlace.requireNoFile(word, folder);
        Path place = FolderPlace.existing(folder.toAbsolutePath());
        if (place != null && !Files.isWritable(place)) {
            throw new UserError(word + "=" + folder + ": cannot be written; name another place");
        }
    }

    /** Writes a text, and makes missing folders. */
    public static void write(Path file, String text) {
        write(file, text.getBytes(StandardCharsets.UTF_8));
    }

    /** Writes bytes, and makes missing folders. If that fails, an existing file stays unchanged. */
    public static void write(Path file, byte[] content) {
        try {
            DurableFiles.writeNamed(file, content);
        } catch (IOException e) {
            throw FileErrors.unwritable(file, e);
        }
    }
}
