package mmneat.experiment.run;

import java.nio.file.Path;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.Parameters;

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
