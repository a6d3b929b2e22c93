package mmneat.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import mmneat.analysis.statistics.CsvText;
import mmneat.analysis.statistics.Numbers;
import mmneat.analysis.statistics.TextTable;
import mmneat.analysis.tasks.Episode;
import mmneat.analysis.tasks.TaskDivision;
import mmneat.analysis.tasks.TaskMeasurement;
import mmneat.analysis.tasks.TaskMeter;
import mmneat.cli.options.GhostsOption;
import mmneat.cli.options.JarOption;
import mmneat.cli.options.Range;
import mmneat.cli.options.TaskOption;
import mmneat.cli.output.OutputFile;
import mmneat.cli.output.ProgressTicker;
import mmneat.contest.entry.ControllerLoader;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.parameters.Tasks;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TaskVersion;
import org.apache.commons.math3.stat.descriptive.DescriptiveStatistics;
import org.jspecify.annotations.Nullable;
import pacman.controllers.Controller;
import pacman.game.Constants.MOVE;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/**
 * The command {@code tasks}: plays games and measures how they divide into subtasks, such as eating pills: how often
 * the subtask changes and how often subtasks overlap. From that follows whether a division of the game is isolated,
 * interleaved or blended by the definitions of the paper. The option {@code task=} is, as in all commands, the version
 * of the whole task.
 */
@Command(
        name = "tasks",
        customSynopsis = "mmneat tasks [name=value...]",
        description = {
            "Measures how the game divides into tasks.",
            "",
            "Prints how often the task changes per time step (thrashing rate) and in what share of the "
                    + "steps tasks overlap, and hence whether the tasks are isolated, interleaved or blended.",
            "",
            "Predicates: " + TasksCommand.PREDICATES,
            "",
            "Example: mmneat tasks",
            "Example: mmneat tasks task=blended predicates=AnyGhostEdible "
                    + "players=StarterPacMan,champion.json games=200",
            "",
        })
final class TasksCommand extends ConsoleCommand implements Runnable {

    static final String PREDICATES =
            "threats (a ghost outside the lair is not edible), edible (a ghost is edible), pills (pills or"
                    + " power pills are left), noPills. A division among modules may be given instead: each module is"
                    + " then a task.";

    private static final int RATE_DECIMALS = 5;

    @Option(
            names = "task",
            paramLabel = "TASK",
            completionCandidates = TaskOption.Versions.class,
            description = "Version of the game: ${COMPLETION-CANDIDATES} (default: all three, one after the other).")
    private @Nullable String task;

    @Option(
            names = "predicates",
            paramLabel = "NAME,...",
            description =
                    "Two or more predicates, or one division, such as AnyGhostEdible (default: pills,noPills in the"
                            + " isolated version, threats,edible in the others).")
    private @Nullable String predicates;

    @Option(
            names = "players",
            paramLabel = "NAME,...",
            description = "Controllers, folders of runs, files with evolved networks, or champion:NAME"
                    + " (default: the champion of the version).")
    private @Nullable String players;

    @Option(
            names = "games",
            paramLabel = "N",
            defaultValue = "100",
            description = "Trials per player; in the isolated version a trial has five games"
                    + " (default: ${DEFAULT-VALUE}).")
    @Range(min = 1, max = 1_000_000)
    private int games;

    @Option(
            names = "seed",
            paramLabel = "N",
            defaultValue = "0",
            description = "Seed of the games (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Mixin
    private GhostsOption ghosts;

    @Mixin
    private JarOption jar;

    @Option(names = "out", paramLabel = "FILE", description = "Also writes one line per game to this CSV file.")
    private @Nullable Path out;

    @Override
    public void run() {
        List<String> versions = task == null ? TaskVersion.labels() : List.of(task);
        ghosts.requireEffect(
                versions.contains(TaskVersion.ISOLATED.label()),
                "only the isolated version has recorded ghost locations");
        Path table = out;
        if (table != null) {
            OutputFile.require("out", table);
            for (String name : players == null ? List.<String>of() : names(players)) {
                NetworkPlayer.file(name)
                        .ifPresent(file -> OutputFile.requireOther("out", table, "players=" + name, file));
            }
        }
        CsvText csv = new CsvText(
                "task",
                "predicates",
                "player",
                "game",
                "steps",
                "switches",
                "thrashing_rate",
                "overlapping_steps",
                "score");
        for (String version : versions) {
            MsPacManTaskSettings settings = settings(version);
            TaskDivision division = predicates == null
                    ? TaskDivision.usual(settings.games().version())
                    : TaskDivision.named(predicates);
            TaskMeter meter = new TaskMeter(settings, division);
            List<String> names = players == null ? List.of(NetworkPlayer.SHIPPED + version) : names(players);
            List<TaskMeasurement> measured = new ArrayList<>();
            for (String name : names) {
                TaskMeasurement measurement = measure(meter, version, name);
                measured.add(measurement);
                append(csv, version, name, measurement);
            }
            print(version, division, names, measured);
        }
        if (out != null) {
            OutputFile.write(out, csv.text());
        }
    }

    /** The names in the value of {@code players=}. */
    private static List<String> names(String players) {
        List<String> names = List.of(players.split(",", -1));
        if (names.stream().anyMatch(String::isBlank)) {
            throw new UserError("players=" + players + ": a name is missing; separate the names by single commas");
        }
        return names;
    }

    private MsPacManTaskSettings settings(String version) {
        List<String> parameters = new ArrayList<>(List.of("task=" + version));
        if (version.equals(TaskVersion.ISOLATED.label())) {
            ghosts.readableFile().ifPresent(file -> parameters.add(Tasks.GHOST_LOCATIONS + "=" + file));
        }
        return ((MsPacManTask) Tasks.factory(new ParameterReader(ParameterCatalogue.load())
                                .read(parameters)
                                .parameters())
                        .get())
                .settings();
    }

    private Supplier<Controller<MOVE>> player(String name) {
        if (NetworkPlayer.isNetwork(name)) {
            return NetworkPlayer.read(name, Optional.empty(), seed, jar);
        }
        return new ControllerLoader(List.of()).pacMan(name)::create;
    }

    private TaskMeasurement measure(TaskMeter meter, String version, String player) {
        AtomicInteger played = new AtomicInteger();
        return ProgressTicker.during(
                notes(),
                () -> List.of("tasks: " + version + ", " + player + ": " + played + " of " + games + " trials"),
                () -> meter.measure(player(player), games, seed, played::set));
    }

    private void print(String version, TaskDivision division, List<String> names, List<TaskMeasurement> measured) {
        PrintWriter out = out();
        out.println(version + ", divided by " + division.name());
        TextTable table = new TextTable(
                "player", "games", "mean score", "thrashing rate", "sd", "highest", "overlap", "the tasks are");
        for (int i = 0; i < names.size(); i++) {
            TaskMeasurement measurement = measured.get(i);
            DescriptiveStatistics rates = measurement.thrashingRates();
            table.row(
                    names.get(i),
                    String.valueOf(measurement.episodes().size()),
                    Numbers.score(measurement.meanScore()),
                    Numbers.decimal(rates.getMean(), RATE_DECIMALS),
                    Numbers.decimal(rates.getStandardDeviation(), RATE_DECIMALS),
                    Numbers.decimal(rates.getMax(), RATE_DECIMALS),
                    percent(measurement.overlap()),
                    measurement.version().label());
        }
        out.print(table.text());
        for (int i = 0; i < names.size(); i++) {
            out.println(names.get(i) + ": " + shares(measured.get(i)));
            out.println(reason(measured.get(i)));
        }
        out.println();
        out.flush();
    }

    /** Returns the share of time in which each subtask, and each pair of subtasks, is active. */
    private static String shares(TaskMeasurement measurement) {
        TaskDivision division = measurement.division();
        List<String> shares = new ArrayList<>();
        for (int i = 0; i < division.tasks().size(); i++) {
            shares.add(division.tasks().get(i).name() + " " + percent(measurement.share(i, i)));
        }
        for (int i = 0; i < division.tasks().size(); i++) {
            for (int j = i + 1; j < division.tasks().size(); j++) {
                double both = measurement.share(i, j);
                if (both > 0) {
                    shares.add(division.tasks().get(i).name() + " and "
                            + division.tasks().get(j).name() + " overlap in " + percent(both));
                }
            }
        }
        return String.join(", ", shares) + " of the steps";
    }

    private static String reason(TaskMeasurement measurement) {
        String bound = Numbers.decimal(TaskMeasurement.INTERLEAVED_BOUND, 2);
        TaskVersion version = measurement.version();
        return "  " + version.label() + ": "
                + switch (version) {
                    case ISOLATED -> "within a game the task never changes";
                    case INTERLEAVED -> "tasks never overlap, and the mean thrashing rate is at most " + bound;
                    case BLENDED ->
                        measurement.overlap() > 0 ? "tasks overlap" : "the mean thrashing rate is above " + bound;
                };
    }

    private static String percent(double share) {
        return Numbers.decimal(100 * share, 1) + " %";
    }

    private static void append(CsvText csv, String version, String name, TaskMeasurement measurement) {
        int game = 0;
        for (Episode episode : measurement.episodes()) {
            csv.row(
                    version,
                    measurement.division().name(),
                    name,
                    game++,
                    episode.steps(),
                    episode.switches(),
                    episode.thrashingRate(),
                    episode.overlapping(),
                    episode.score());
        }
    }
}
