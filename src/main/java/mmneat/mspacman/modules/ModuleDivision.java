package mmneat.mspacman.modules;

import mmneat.mspacman.sensors.Observation;

/**
 * A human-specified division of the task: says which output module of a network is used in a time step.
 *
 * <p>To use a division of one's own, write a class that implements this interface and has a public constructor without
 * arguments, and name it in {@code pacmanMultitaskScheme}. It keeps no state.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 6.
 */
public interface ModuleDivision {

    /** Number of modules that are chosen from, at least 2. */
    int modules();

    /**
     * The module for all directions of this time step, in [0, {@link #modules()}).
     *
     * @param observation the state of the game; what depends on a direction must not be asked
     */
    int module(Observation observation);

    /** In a few words, when a module is used; for pictures and tables. */
    default String observation(int module) {
        return "observation " + (module + 1);
    }
}
