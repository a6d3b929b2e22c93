package mmneat.mspacman.modules;

import mmneat.mspacman.sensors.Observation;

/**
 * A human-specified division of the task, which selects the output module of a multitask network in each time step.
 *
 * <p>A division of the user's own is a class with a public constructor without arguments, named in {@code
 * pacmanMultitaskScheme}. It keeps no state: one object serves all threads of a run.
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
