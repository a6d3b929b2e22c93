package mmneat.mspacman.modules;

import mmneat.mspacman.sensors.Observation;

/**
 * A human-specified division of the task, which selects the output module of a multitask network in each time step.
 *
 * <p>To add a division, write a class that implements this interface and has a public constructor without arguments,
 * and name it in {@code pacmanMultitaskScheme}. A division keeps no state.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 6.
 */
public interface ModuleDivision {

    /** Number of modules, at least 2. */
    int modules();

    /**
     * Returns the module for all directions of this time step, in [0, {@link #modules()}).
     *
     * @param observation the state of the game; methods that depend on a direction must not be called
     */
    int module(Observation observation);

    /** Returns a short description of when a module is used, for pictures and tables. */
    default String observation(int module) {
        return "observation " + (module + 1);
    }
}
