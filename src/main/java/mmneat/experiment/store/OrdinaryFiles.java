package mmneat.experiment.store;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import java.util.stream.Stream;
import mmneat.experiment.FileErrors;
import mmneat.experiment.UserError;

/**
 * The check that the files of a run are ordinary files, because the folder may come from another person. A symbolic
 * link could lead out of the folder, and reading a pipe may never end. The folder itself may be a link, because the
 * user names it.
 */
public final class OrdinaryFiles {

    /** The folders in a run's folder whose files are replaced in every generation. */
    private static final List<String> INNER_FOLDERS = List.of("bestPacMan", "bestObjectives");

    private OrdinaryFiles() {}

    /**
     * Checks that a file of a run, if it exists, is neither a symbolic link nor a pipe, socket or device. It may be a
     * folder: reading that fails at once.
     *
     * @throws UserError if it is one of them
     */
    public static void require(Path file) {
        BasicFileAttributes attributes;
        try {
            attributes = Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
        } catch (NoSuchFileException e) {
            return;
        } catch (IOException e) {
            throw FileErrors.unreadable(file, e);
        }
        if (attributes.isSymbolicLink()) {
            throw new UserError(
                    file + ": is a symbolic link, and the files of a run are not read or written through links;"
                            + " put the file itself there, or remove the link");
        }
        if (attributes.isOther()) {
            throw new UserError(
                    file + ": is a pipe, socket or device, and the files of a run are ordinary files; remove it");
        }
    }

    /**
     * Checks that the folder of a run, if it exists, contains only ordinary files and folders.
     *
     * @throws UserError naming the first that is neither
     */
    public static void requireIn(Path folder) {
        requireAmong(folder);
        INNER_FOLDERS.stream()
                .map(folder::resolve)
                .filter(inner -> Files.isDirectory(inner, LinkOption.NOFOLLOW_LINKS))
                .forEach(OrdinaryFiles::requireAmong);
    }

    private static void requireAmong(Path folder) {
        if (!Files.isDirectory(folder)) {
            return;
        }
        try (Stream<Path> entries = Files.list(folder)) {
            entries.sorted().forEach(OrdinaryFiles::require);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
