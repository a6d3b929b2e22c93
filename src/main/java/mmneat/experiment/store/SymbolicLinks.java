package mmneat.experiment.store;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import mmneat.experiment.UserError;

/**
 * The check that no file of a run is read or written through a symbolic link, because the folder may come from another
 * person. The folder itself may be a link, because the user names it.
 */
public final class SymbolicLinks {

    /** The folders in a run's folder whose files are replaced in every generation. */
    private static final List<String> INNER_FOLDERS = List.of("bestPacMan", "bestObjectives");

    private SymbolicLinks() {}

    /**
     * Checks that a file of a run, if it exists, is not a symbolic link.
     *
     * @throws UserError if it is one
     */
    public static void refuse(Path file) {
        if (Files.isSymbolicLink(file)) {
            throw new UserError(
                    file + ": is a symbolic link, and the files of a run are not read or written through links;"
                            + " put the file itself there, or remove the link");
        }
    }

    /**
     * Checks that the folder of a run, if it exists, contains no symbolic links.
     *
     * @throws UserError naming the first link
     */
    public static void refuseIn(Path folder) {
        refuseAmong(folder);
        INNER_FOLDERS.stream()
                .map(folder::resolve)
                .filter(inner -> Files.isDirectory(inner, LinkOption.NOFOLLOW_LINKS))
                .forEach(SymbolicLinks::refuseAmong);
    }

    private static void refuseAmong(Path folder) {
        if (!Files.isDirectory(folder)) {
            return;
        }
        try (Stream<Path> entries = Files.list(folder)) {
            entries.filter(Files::isSymbolicLink).sorted().findFirst().ifPresent(SymbolicLinks::refuse);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
