/**
 * Runs as jobs of an existing scheduler: the files that Slurm, HTCondor, Kubernetes or a list of commands need.
 *
 * <p>There is no engine of our own. A run is the unit (its parameters and its own folder, nothing shared); the scheduler
 * places it, retries it and accounts for it. Everything here only writes text; {@link
 * mmneat.experiment.cluster.SlurmSubmission} alone calls a program.
 */
package mmneat.experiment.cluster;
