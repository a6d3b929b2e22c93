package mmneat.mspacman.modules;

import mmneat.mspacman.sensors.Observation;

/**
 * A human-specified division of the task, which selects the output module of a multitask network, or the group of
 * modules of a hybrid, in each time step.
 *
 * <p>A division of your own is a class that implements {@link #modules} and {@link #module} and has a public
 * constructor without arguments. The parameter {@code pacmanMultitaskScheme} of the command line names it with its
 * package; a program that uses the library passes an object to {@code NetworkSettings.withDivision}. It keeps no
 * state: one object serves all threads of a run.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 6.
 */
public interface ModuleDivision {

    /** Number of modules (in a hybrid, groups) among which the division selects, at least 2. */
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
