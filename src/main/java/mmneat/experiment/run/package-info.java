/**
 * The execution of runs: the plan of an experiment, the workers that execute its runs in parallel, and the monitors of
 * their progress. {@link mmneat.experiment} explains the terms: run, experiment, study, champion.
 */
@NullMarked
package mmneat.experiment.run;

import org.jspecify.annotations.NullMarked;
