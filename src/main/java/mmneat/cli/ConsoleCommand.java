package mmneat.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import mmneat.cli.options.OptionValues;
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
        return OptionValues.isGiven(command, option);
    }

    /** Refuses an option where it has no effect; see {@link OptionValues#requireEffect}. */
    final void requireEffect(String option, boolean hasEffect, String reason) {
        OptionValues.requireEffect(command, option, hasEffect, reason);
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
