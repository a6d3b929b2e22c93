package mmneat.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import mmneat.experiment.UserError;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** Base class of commands, with access to the console and to the given options. */
@Command(mixinStandardHelpOptions = true, sortOptions = false, usageHelpWidth = 100)
abstract class ConsoleCommand {

    @Spec
    private CommandSpec command;

    /** This command's parser. */
    final CommandLine commandLine() {
        return command.commandLine();
    }

    /** Writer for results. */
    final PrintWriter out() {
        return command.commandLine().getOut();
    }

    /** Writer for remarks and progress. */
    final PrintWriter notes() {
        return command.commandLine().getErr();
    }

    /** Whether the option was given on the command line. */
    final boolean isGiven(String option) {
        return isGiven(command, option);
    }

    /** Whether the option was given to this command. */
    static boolean isGiven(CommandSpec command, String option) {
        return command.commandLine().getParseResult().hasMatchedOption(option);
    }

    /** Refuses an option where it has no effect; see {@link #requireEffect(CommandSpec, String, boolean, String)}. */
    final void requireEffect(String option, boolean hasEffect, String reason) {
        requireEffect(command, option, hasEffect, reason);
    }

    /**
     * Refuses an option where it has no effect.
     *
     * @param hasEffect whether it has an effect
     * @param reason what the option needs, for the message
     * @throws UserError if the option was given and has no effect
     */
    static void requireEffect(CommandSpec command, String option, boolean hasEffect, String reason) {
        if (!hasEffect && isGiven(command, option)) {
            String value = command.findOption(option).originalStringValues().get(0);
            throw new UserError(option + "=" + value + " has no effect here: " + reason + "; leave it out");
        }
    }

    /** Returns the folders of experiments, and checks that there is at least one. */
    final List<Path> requireExperiments(@Nullable List<Path> experiments) {
        if (experiments == null || experiments.isEmpty()) {
            throw new UserError(
                    "no experiment is given; write mmneat " + command.name() + " results/blended, for example");
        }
        return experiments;
    }
}
