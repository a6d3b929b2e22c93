package mmneat.experiment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import pacman.game.GhostLocations;

/**
 * The ghost locations of an isolated run, {@value #FILE} in its folder: the run goes on with them wherever its folder is, and
 * whatever recording a later version of the program brings along.
 */
final class GhostLocationsCopy {

    /** Its name, and what {@code parameters.properties} says of it. */
    static final String FILE = "ghost-locations.txt";

    static final String PARAMETER = "mazePowerPillGhostMapping";

    private GhostLocationsCopy() {}

    /** The run's parameters; they name the run's own ghost locations as soon as it has them. */
    static Parameters parameters(RunPlan run) {
        return isNeeded(run) && Files.exists(file(run))
                ? run.parameters().with(PARAMETER, file(run))
                : run.parameters();
    }

    /** Gives the run its own ghost locations, unless it has them or needs none. */
    static void keep(RunPlan run) throws IOException {
        if (isNeeded(run) && !Files.exists(file(run))) {
            String asked = run.parameters().text(PARAMETER);
            DurableFiles.write(
                    file(run),
                    asked.isEmpty()
                            ? GhostLocations.shippedText().getBytes(StandardCharsets.UTF_8)
                            : Files.readAllBytes(Path.of(asked)));
        }
    }

    /**
     * Makes sure that the run was begun with the ghost locations that are asked for now, if it was begun and they can be read.
     *
     * @throws UserError if not
     */
    static void requireSame(RunPlan run) throws IOException {
        String asked = run.parameters().text(PARAMETER);
        if (!isNeeded(run) || asked.isEmpty() || !Files.exists(file(run)) || !Files.exists(Path.of(asked))) {
            return;
        }
        if (!Arrays.equals(Files.readAllBytes(Path.of(asked)), Files.readAllBytes(file(run)))) {
            throw new UserError(
                    run.directory() + " was begun with other ghost locations than " + PARAMETER + "=" + asked
                            + "; leave it out to continue with its own (" + FILE
                            + "), or give another folder with base=FOLDER");
        }
    }

    private static boolean isNeeded(RunPlan run) {
        return TaskKind.of(run.parameters()) == TaskKind.ISOLATED;
    }

    private static Path file(RunPlan run) {
        return run.directory().resolve(FILE);
    }
}
