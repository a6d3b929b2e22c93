package mmneat.experiment.run;

import java.nio.file.Path;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.Parameters;
import mmneat.experiment.parameters.StopScore;
import mmneat.experiment.store.RunStatus;

/**
 * The plan of one run: its number, folder and parameters. A run shares nothing with other runs.
 *
 * @param number number of the run
 * @param directory its folder, {@code <base>/<saveTo><number>}
 * @param prefix prefix of the names of its score files and logs, {@code <log><number>_}
 * @param parameters all values, including run number and seed
 */
public record RunPlan(int number, Path directory, String prefix, Parameters parameters) {

    /** Number of generations to complete. */
    public int generations() {
        return parameters.integer("maxGens");
    }

    /**
     * The champion score at which the run ends before its last generation ({@code stopAt}); infinity if there is none.
     */
    public double stopAt() {
        return StopScore.of(parameters.values());
    }

    /** Whether the run needs no more generations: all are complete, or its champion has reached {@link #stopAt}. */
    boolean isFinished(RunStatus status) {
        return status.isFinished(generations())
                || status.state() == RunStatus.State.FINISHED && status.best() >= stopAt();
    }

    /** Seed of the run's generator. */
    public int seed() {
        return parameters.integer("randomSeed");
    }

    /**
     * Checks that the run has not completed more generations than requested, because generations cannot be undone.
     *
     * @throws UserError if it has
     */
    void requireAtLeast(int completed) {
        if (completed > generations()) {
            throw new UserError(directory + " has completed " + completed + " generations, more than maxGens="
                    + generations() + "; give maxGens=" + completed + " or more to continue it, or another folder with"
                    + " base=FOLDER");
        }
    }
}
