package mmneat.experiment.parameters;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Supplier;
import mmneat.evolution.Task;
import mmneat.experiment.FileErrors;
import mmneat.experiment.TextFiles;
import mmneat.experiment.UserError;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TaskVersion;
import pacman.game.GhostLocations;

/** Factory of the tasks that parameters describe. */
public final class Tasks {

    /**
     * The parameter that names a file of ghost locations: the places of the ghosts, recorded from games, at which the
     * ghosts start in the games of eating ghosts of the isolated version. An empty value means the recording shipped
     * with the program.
     */
    public static final String GHOST_LOCATIONS = "mazePowerPillGhostMapping";

    /** The value of {@link #GHOST_LOCATIONS} for the recording shipped with the program: an empty path. */
    public static final Path SHIPPED_LOCATIONS = Path.of("");

    private Tasks() {}

    /**
     * Returns a factory of tasks, each for one thread.
     *
     * @throws UserError if the parameters do not describe a task
     */
    public static Supplier<Task> factory(Parameters parameters) {
        return PublishedTask.version(parameters)
                .map(version -> game(parameters, version))
                .orElseGet(
                        () -> OwnTask.factory(parameters.text("task"), parameters.text("jar"), parameters.ofOwnTask()));
    }

    private static Supplier<Task> game(Parameters parameters, TaskVersion version) {
        MsPacManTaskSettings settings = gameSettings(parameters, version);
        return () -> new MsPacManTask(settings);
    }

    private static MsPacManTaskSettings gameSettings(Parameters parameters, TaskVersion version) {
        GhostLocations locations = version == TaskVersion.ISOLATED ? locations(parameters.text(GHOST_LOCATIONS)) : null;
        try {
            return parameters.as(GameParameters.class).settings(version, locations);
        } catch (IllegalArgumentException e) {
            throw new UserError(e.getMessage(), e);
        }
    }

    private static GhostLocations locations(String file) {
        if (file.isEmpty()) {
            return GhostLocations.shipped();
        }
        try {
            return GhostLocations.read(file, TextFiles.reader(Path.of(file)));
        } catch (IOException e) {
            throw FileErrors.unreadable(GHOST_LOCATIONS + "=" + file, e);
        } catch (IllegalArgumentException e) {
            throw new UserError(GHOST_LOCATIONS + "=" + e.getMessage(), e);
        }
    }
}
