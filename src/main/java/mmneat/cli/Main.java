package mmneat.cli;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import mmneat.experiment.UserError;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Help;
import picocli.CommandLine.IHelpSectionRenderer;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.UsageMessageSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/**
 * Entry point of {@code mmneat.jar}: finds the command and runs it.
 *
 * <p>Exit codes: 0 done, 1 a failure of ours (with a stack trace), 2 a mistake of the user (one line).
 */
@Command(
        name = "mmneat",
        mixinStandardHelpOptions = true,
        versionProvider = Main.Version.class,
        description = "Modular Multiobjective NEAT for Ms. Pac-Man.",
        subcommands = {CompareCommand.class, NetworkCommand.class, PlayCommand.class, ReplayCommand.class})
public final class Main implements Runnable {
public final class Main implements Callable<Integer> {
