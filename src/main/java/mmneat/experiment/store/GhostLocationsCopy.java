package mmneat.experiment.store;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import mmneat.experiment.TextFiles;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.Parameters;
import mmneat.experiment.parameters.PublishedTask;
import mmneat.experiment.parameters.Tasks;
import mmneat.mspacman.TaskVersion;
import pacman.game.GhostLocations;

/**
 * The copy of the ghost locations, {@code ghost-locations.txt}, in the folder of a run of the isolated version of the
 * task: the recorded places at which ghosts start in its games of eating ghosts. With the copy the run continues
 * unchanged if its folder is moved or a later version of the program ships another recording.
 */
public final class GhostLocationsCopy {

    private GhostLocationsCopy() {}

    /** Returns the run's parameters. They name the run's own copy if it exists. */
    public static Parameters parameters(Path directory, Parameters parameters) {
        return isNeeded(parameters) && Files.exists(file(directory))
                ? parameters.with(Tasks.GHOST_LOCATIONS, file(directory))
                : parameters;
    }

    /** Makes the run's copy, unless it exists or the run needs none. */
    public static void keep(Path directory, Parameters parameters) throws IOException {
        if (isNeeded(parameters) && !Files.exists(file(directory))) {
            String asked = parameters.text(Tasks.GHOST_LOCATIONS);
            DurableFiles.write(
                    file(directory),
                    asked.isEmpty()
                            ? GhostLocations.shippedText().getBytes(StandardCharsets.UTF_8)
                            : TextFiles.bytes(Path.of(asked), TextFiles.TABLE_MIB));
        }
    }

    /**
     * Checks that the run was started with the requested ghost locations, if it was started and they can be read.
     *
     * @throws UserError if not
     */
    public static void requireSame(Path directory, Parameters parameters) throws IOException {
        String asked = parameters.text(Tasks.GHOST_LOCATIONS);
        if (!isNeeded(parameters)
                || asked.isEmpty()
                || !Files.exists(file(directory))
                || !Files.exists(Path.of(asked))) {
            return;
        }
        if (!Arrays.equals(
                TextFiles.bytes(Path.of(asked), TextFiles.TABLE_MIB),
                TextFiles.bytes(file(directory), TextFiles.TABLE_MIB))) {
            throw new UserError(
                    directory + " was begun with other ghost locations than " + Tasks.GHOST_LOCATIONS + "=" + asked
                            + "; leave it out to continue with its own (" + RunLayout.GHOST_LOCATIONS
                            + "), or give another folder with base=FOLDER");
        }
    }

    private static boolean isNeeded(Parameters parameters) {
        return PublishedTask.version(parameters)
                .filter(TaskVersion.ISOLATED::equals)
                .isPresent();
    }

    private static Path file(Path directory) {
        return directory.resolve(RunLayout.GHOST_LOCATIONS);
    }
}
