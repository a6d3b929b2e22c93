/**
 * Job files for schedulers: scripts for Slurm, HTCondor and Kubernetes, and lists of commands.
 *
 * <p>One run is one job, which needs only its parameters and its own folder. The scheduler places, repeats and accounts
 * for jobs. All classes only write text, except {@link mmneat.experiment.cluster.SlurmSubmission}, which calls
 * programs. The words of a job are parameters of the command line, each {@code name=value}.
 */
@NullMarked
package mmneat.experiment.cluster;

import org.jspecify.annotations.NullMarked;
