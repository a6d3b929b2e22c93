/**
 * The execution of runs: the plan of an experiment, the workers that execute its runs in parallel, and the monitors of
 * their progress.
 */
package mmneat.experiment.run;
