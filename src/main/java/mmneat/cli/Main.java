package mmneat.cli;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import mmneat.cli.options.ArgumentSyntax;
import mmneat.cli.options.OptionValues;
import mmneat.cli.output.Display;
import mmneat.cli.output.StandardOutput;
import mmneat.cli.output.Terminal;
import mmneat.experiment.ExitGuard;
import mmneat.experiment.FileErrors;
import mmneat.experiment.NearestName;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;
import mmneat.neat.BadPartException;
import mmneat.neat.Thrown;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;

/**
 * Entry point of {@code mmneat.jar}: finds the command and runs it; without a command, the main job ({@link MainJob}),
 * which evolves.
 *
 * <table>
 *   <caption>Exit codes</caption>
 *   <tr><th>code</th><th>meaning</th></tr>
 *   <tr><td>0</td><td>success; of the main job: all runs are complete</td></tr>
 *   <tr><td>1</td><td>a bug of the program or a user's class (stack trace); main job: also a failed run</td></tr>
 *   <tr><td>2</td><td>an error of the user (one line)</td></tr>
 *   <tr><td>3</td><td>main job only: another process holds the lock of a run's folder</td></tr>
 *   <tr><td>4, 5</td><td>command {@code status} only: some runs are not finished; some have failed</td></tr>
 *   <tr><td>130, 143</td><td>interrupted by Ctrl-C, by SIGTERM; these codes are the system's</td></tr>
 * </table>
 */
@Command(
        name = "mmneat",
        mixinStandardHelpOptions = true,
        versionProvider = Main.Version.class,
        usageHelpWidth = 100,
        description = {
            "Evolves modular neural networks that play Ms. Pac-Man (Modular Multiobjective NEAT).",
            "",
            "Without a command, runs the experiment that the parameters describe.",
            "Example: mmneat task=blended runs=30",
            "",
        },
        footer = "Each command has its own --help.",
        subcommands = {
            CompareCommand.class,
            CompletionCommand.class,
            EvaluateCommand.class,
            ReportCommand.class,
            WatchCommand.class,
            ParamsCommand.class,
            StatusCommand.class,
            NetworkCommand.class,
            PlayCommand.class,
            ProcessCommand.class,
            RecordGhostsCommand.class,
            ReplayCommand.class,
            SubmitCommand.class,
            TasksCommand.class
        })
public final class Main implements Callable<Integer> {

    private static final Set<String> MAY_OPEN_A_WINDOW = Set.of("play", "replay", "watch");

    @Spec
    private CommandSpec command;

    @Parameters(
            arity = "0..*",
            paramLabel = ArgumentSyntax.PARAMETER,
            description = "Parameters of the experiment; see params.")
    private List<String> words = new ArrayList<>();

    public static void main(String[] arguments) {
        if (arguments.length == 0 || !MAY_OPEN_A_WINDOW.contains(arguments[0])) {
            Display.drawWithoutScreen();
        }
        CommandLine main = commandLine();
        if (!Files.isDirectory(Path.of("").toAbsolutePath())) {
            main.getErr()
                    .println(
                            "mmneat: the name of this folder has letters that the locale cannot represent, so files would be"
                                    + " written elsewhere; set LC_ALL=C.UTF-8 or use another folder");
            main.getErr().flush();
            System.exit(ExitCode.USAGE);
        }
        StandardOutput output = new StandardOutput(new FileOutputStream(FileDescriptor.out));
        System.setOut(new PrintStream(output, true, StandardOutput.encoding()));
        System.exit(execute(main, output, arguments));
    }

    /**
     * Runs a command and reports if its output could not be written. A pipe that was closed by its reader is not
     * a failure.
     *
     * @return the exit code of the command; 2 if it succeeded but its output could not be written
     */
    static int execute(CommandLine main, StandardOutput output, String... arguments) {
        main.setOut(new PrintWriter(new OutputStreamWriter(output, StandardOutput.encoding()), true));
        int code = run(main, arguments);
        main.getOut().flush();
        Optional<IOException> failure = output.failure();
        if (failure.isEmpty()) {
            return code;
        }
        main.getErr().println("mmneat: standard output cannot be written: " + FileErrors.reason(failure.get()));
        main.getErr().flush();
        return code == ExitCode.OK ? ExitCode.USAGE : code;
    }

    /** Runs a command; reports in one line that its input, such as a device without an end, exhausted the memory. */
    private static int run(CommandLine main, String... arguments) {
        try {
            return main.execute(arguments);
        } catch (OutOfMemoryError e) {
            main.getErr()
                    .println("mmneat: out of memory; check the files that the command names, or give Java"
                            + " more memory with the option -Xmx");
            main.getErr().flush();
            return ExitCode.USAGE;
        }
    }

    /** The whole command line; tests set its output and error writers. */
    static CommandLine commandLine() {
        CommandLine main = new CommandLine(new Main());
        for (CommandLine each : main.getSubcommands().values()) {
            configure(each);
        }
        return common(main);
    }

    /** Sets how a command parses its options and handles errors. */
    static CommandLine configure(CommandLine line) {
        line.getCommandSpec().preprocessor(new ArgumentSyntax());
        line.getCommandSpec().versionProvider(new Version());
        return common(line);
    }

    private static CommandLine common(CommandLine line) {
        OptionValues.register(line);
        // ArgumentSyntax refuses unknown options with a better suggestion than picocli.
        line.setUnmatchedOptionsArePositionalParams(true);
        line.setAllowOptionsAsOptionParameters(true);
        line.setPosixClusteredShortOptionsAllowed(false);
        line.setExpandAtFiles(false);
        if (!Terminal.understandsEscapes()) {
            line.setColorScheme(Help.defaultColorScheme(Help.Ansi.OFF));
        }
        line.setExecutionStrategy(Main::checkAndRun);
        line.setExecutionExceptionHandler((failure, command, parsed) -> report(failure, command));
        line.setParameterExceptionHandler((mistake, arguments) -> report(mistake));
        return line;
    }

    /** Runs a command that parsed the command line. Commands that evolve or play guard their own work. */
    private static int checkAndRun(ParseResult parsed) {
        ParseResult command = parsed.hasSubcommand() ? parsed.subcommand() : parsed;
        try {
            if (!command.isUsageHelpRequested() && !command.isVersionHelpRequested()) {
                OptionValues.check(command);
            } else if (command.commandSpec().userObject() instanceof Main main && !main.words.isEmpty()) {
                main.requireParameters(command.commandSpec().commandLine());
            }
        } catch (UserError e) {
            throw new ParameterException(command.commandSpec().commandLine(), e.getMessage(), e);
        }
        CommandLine line = command.commandSpec().commandLine();
        Object user = command.commandSpec().userObject();
        if (user instanceof Main || user instanceof SubmitCommand || user instanceof PlayCommand) {
            return new CommandLine.RunLast().execute(parsed);
        }
        return ExitGuard.guard(line.getErr(), () -> new CommandLine.RunLast().execute(parsed));
    }

    /**
     * Runs the main job if no command is given; prints the first commands for a newcomer if there are no words at all.
     */
    @Override
    public Integer call() throws Exception {
        CommandLine line = command.commandLine();
        if (words.isEmpty() || words.equals(List.of("help"))) {
            FirstPage.print(line.getOut());
            return ExitCode.OK;
        }
        requireParameters(line);
        return new MainJob(words, line.getOut(), line.getErr()).call();
    }

    /** Refuses a first word without "=" or ":", which was meant to be a command. */
    private void requireParameters(CommandLine line) {
        String first = words.get(0);
        if (words.equals(List.of("help"))) {
            return;
        }
        if (first.startsWith("-")) {
            throw new ParameterException(line, "unknown option '" + first + "'");
        }
        if (first.indexOf('=') < 0 && first.indexOf(':') < 0) {
            throw new UserError("'" + first + "' is not a command"
                    + NearestName.suggestion(first, line.getSubcommands().keySet())
                    + ". Parameters are written name=value. See --help for the list of commands.");
        }
    }

    private static int report(Exception failure, CommandLine line) {
        PrintWriter errors = line.getErr();
        Optional<String> mistake = mistake(failure);
        if (mistake.isPresent()) {
            errors.println("mmneat: " + PlainText.shown(mistake.get()));
        } else {
            errors.print(new Thrown(failure).trace());
        }
        errors.flush();
        return mistake.isPresent() ? ExitCode.USAGE : ExitCode.SOFTWARE;
    }

    /** Returns the one-line message of a user's error; empty for a bug of the program. */
    private static Optional<String> mistake(Exception failure) {
        if (failure instanceof UserError) {
            return Optional.ofNullable(failure.getMessage());
        }
        if (failure instanceof UncheckedIOException unchecked) {
            return Optional.of(FileErrors.sentence(Objects.requireNonNull(unchecked.getCause())));
        }
        if (failure instanceof FileSystemException file) {
            return Optional.of(FileErrors.sentence(file));
        }
        if (failure instanceof InvalidPathException name) {
            return Optional.of("'" + name.getInput() + "' cannot be the name of a file here (" + name.getReason()
                    + "); if it has letters beyond ASCII, set LC_ALL=C.UTF-8");
        }
        return BadPartException.in(failure).map(BadPartException::getMessage);
    }

    private static int report(ParameterException mistake) {
        CommandLine line = mistake.getCommandLine();
        String help = "; see " + line.getCommandSpec().qualifiedName() + " --help";
        String message =
                OptionValues.refusal(mistake).map(UserError::getMessage).orElseGet(() -> mistake.getMessage() + help);
        line.getErr().println("mmneat: " + message);
        line.getErr().flush();
        return ExitCode.USAGE;
    }

    /** The version that the build wrote into the jar. */
    static final class Version implements CommandLine.IVersionProvider {
        @Override
        public String[] getVersion() {
            String version = Main.class.getPackage().getImplementationVersion();
            return new String[] {"MM-NEAT " + (version == null ? "(not packaged)" : version)};
        }
    }
}
