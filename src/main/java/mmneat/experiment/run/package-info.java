/**
 * Runs: the plan of an experiment, the workers that do its runs side by side, and the monitors of their progress.
 */
package mmneat.experiment.run;
