package mmneat.experiment.run;

import java.nio.file.Path;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.Parameters;
import mmneat.experiment.store.RunStatus;

/**
 * One run: it needs nothing but its parameters and its own folder, and shares nothing with other runs.
 *
 * @param number number of the run
 * @param directory its folder, {@code <base>/<saveTo><number>}
 * @param prefix what the names of its score files and logs start with, {@code <log><number>_}
 * @param parameters all values, number and seed included
 */
public record RunPlan(int number, Path directory, String prefix, Parameters parameters) {

    /** Generations that the run is to complete. */
    public int generations() {
        return parameters.integer("maxGens");
    }

    /** The champion score at which the run ends before its last generation ({@code stopAt}); infinity if there is none. */
    public double stopAt() {
        String text = parameters.text("stopAt");
        try {
            return text.isEmpty() ? Double.POSITIVE_INFINITY : Double.parseDouble(text);
        } catch (NumberFormatException e) {
            throw new UserError("stopAt=" + text + ": must be a number", e);
        }
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
     * Makes sure that the run has not gone farther than it is to go: generations cannot be taken back.
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
