/**
 * The command line: the main job, which runs experiments, and one class per command.
 *
 * <p>{@link mmneat.cli.Main} is the entry point of {@code mmneat.jar}. The commands only parse options and print
 * results; the packages below do the work.
 */
package mmneat.cli;
