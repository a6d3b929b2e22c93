package mmneat.cli.output;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import mmneat.experiment.FileErrors;
import mmneat.experiment.FolderPlace;
import mmneat.experiment.UserError;
import mmneat.experiment.run.ExperimentView;
import mmneat.experiment.store.DurableFiles;
import mmneat.experiment.store.RunLayout;

/** Writes files that the user named. */
public final class OutputFile {

    /** The name by which standard output is asked for, instead of a file. */
    public static final Path STANDARD_OUTPUT = Path.of("-");

    private OutputFile() {}

    /**
     * Checks that a file can be written, before a long computation.
     *
     * @param word the option with this file, for messages
     */
    public static void require(String word, Path file) {
        requireName(word, file);
        requireOutsideRuns(word + "=" + file, file);
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
        requireName(word, folder);
        FolderPlace.requireNoFile(word, folder);
        Path place = FolderPlace.existing(folder.toAbsolutePath());
        if (place != null && !Files.isWritable(place)) {
            throw new UserError(word + "=" + folder + ": cannot be written; name another place");
        }
    }

    private static void requireName(String word, Path file) {
        if (file.equals(STANDARD_OUTPUT)) {
            throw new UserError(word + "=-: standard output is not possible here; name a file or folder");
        }
    }

    /** Refuses files of a run: a command that reads runs must not replace what they have written. */
    private static void requireOutsideRuns(String label, Path file) {
        try {
            if (Files.isRegularFile(file) && ExperimentView.isListOfRuns(file.toRealPath())) {
                throw new UserError(label + ": this is the list of an experiment's runs; give another name");
            }
            Optional<Path> run = RunLayout.runWith(file);
            if (run.isPresent()) {
                throw new UserError(
                        label + ": a file of this name belongs to the run in " + run.get() + "; give another name");
            }
        } catch (IOException e) {
            throw FileErrors.unwritable(label, e);
        }
    }

    /**
     * Refuses a file to be written that is also another file of the same command, written or read.
     *
     * @param word the option with this file, for messages
     * @param otherWord the words that describe the other file, for messages
     */
    public static void requireOther(String word, Path file, String otherWord, Path other) {
        try {
            if (!isDevice(file)
                    && !isDevice(other)
                    && FolderPlace.withoutLinks(file).equals(FolderPlace.withoutLinks(other))) {
                throw new UserError(
                        word + "=" + file + ": this is also the file of " + otherWord + "; give another name");
            }
        } catch (IOException e) {
            throw FileErrors.unwritable(word + "=" + file, e);
        }
    }

    private static boolean isDevice(Path file) {
        return Files.exists(file) && !Files.isRegularFile(file);
    }

    /** Writes a text, and makes missing folders. */
    public static void write(Path file, String text) {
        write(file, text.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Writes bytes, and makes missing folders. If that fails, an existing file stays unchanged.
     *
     * @throws UserError if that fails, or the file belongs to a run
     */
    public static void write(Path file, byte[] content) {
        requireOutsideRuns(file.toString(), file);
        try {
            DurableFiles.writeNamed(file, content);
        } catch (IOException e) {
            throw FileErrors.unwritable(file, e);
        }
    }
}
