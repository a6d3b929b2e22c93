/**
 * The command line: the main job, which runs experiments, and one class per command.
 *
 * <p>{@link mmneat.cli.Main} is the entry point of {@code mmneat.jar}. The commands only parse options and print
 * results; the packages {@code mmneat.experiment}, {@code mmneat.analysis} and {@code mmneat.contest} do the work.
 * {@link mmneat.experiment} explains the terms: the original, the paper, run, experiment, method, task and its
 * versions, trial, champion.
 */
@NullMarked
package mmneat.cli;

import org.jspecify.annotations.NullMarked;
