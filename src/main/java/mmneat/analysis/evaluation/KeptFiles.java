package mmneat.analysis.evaluation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import mmneat.experiment.FileErrors;
import mmneat.experiment.UserError;
import mmneat.experiment.store.DurableFiles;

/** Keeps the content of a file that is about to be replaced, as NAME-old-1, NAME-old-2, ... beside it. */
final class KeptFiles {

    private KeptFiles() {}

    /**
     * Writes the content to the first free name. If a file of these names holds it already, nothing is written.
     *
     * @return the file that holds the content
     * @throws UserError if it cannot be written
     */
    static Path keep(Path file, byte[] content) {
        String name = file.getFileName().toString();
        int end = name.lastIndexOf('.');
        try {
            for (int number = 1; ; number++) {
                Path copy = file.resolveSibling(name.substring(0, end) + "-old-" + number + name.substring(end));
                if (!Files.exists(copy)) {
                    DurableFiles.write(copy, content);
                    return copy;
                }
                if (Files.size(copy) == content.length && Arrays.equals(Files.readAllBytes(copy), content)) {
                    return copy;
                }
            }
        } catch (IOException e) {
            throw FileErrors.unwritable(file, e);
        }
    }
}
