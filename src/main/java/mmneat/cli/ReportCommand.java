package mmneat.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import mmneat.analysis.ExperimentComparison;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.ChampionEvaluator;
import mmneat.analysis.evaluation.Rules;
import mmneat.analysis.figures.Figure;
import mmneat.analysis.replay.GameRecording;
import mmneat.analysis.replay.ReplayPage;
import mmneat.analysis.replay.ReplayTitle;
import mmneat.analysis.report.ExperimentReport;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.MethodName;
import mmneat.analysis.results.PublishedResults;
import mmneat.analysis.results.RunResult;
import mmneat.cli.options.GhostsOption;
import mmneat.cli.options.JarOption;
import mmneat.cli.options.TaskOption;
import mmneat.cli.output.OutputFile;
import mmneat.mspacman.MsPacManTaskSettings;
import org.jspecify.annotations.Nullable;
import pacman.game.MachineFonts;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The command {@code report}: writes a page about a set of experiments, with figures and replays. */
@Command(
        name = "report",
        customSynopsis = "mmneat report EXPERIMENT... [name=value...]",
        description = {
            "Writes a web page about experiments.",
            "",
            "The page has figures, statistics, the champions with their networks and replays, and the "
                    + "settings. It is one file that a browser opens from disk.",
            "",
            "Example: mmneat report results/blended out=blended.html",
            "Example: mmneat report results/blended results/isolated figures=pictures replays=best",
            "",
        })
final class ReportCommand extends ConsoleCommand implements Runnable {

    private static final class Replays extends ArrayList<String> {
        Replays() {
            super(List.of("all", "best", "none"));
        }
    }

    @Mixin
    private ExperimentsArgument experimentsArgument;

    @Option(
            names = "out",
            paramLabel = "FILE",
            defaultValue = "report.html",
            description = "The page to write (default: ${DEFAULT-VALUE}).")
    private Path out;

    @Option(
            names = "title",
            paramLabel = "TEXT",
            description = "Heading of the page (default: the experiments' names).")
    private @Nullable String title;

    @Option(names = "figures", paramLabel = "FOLDER", description = "Also writes the figures there, as SVG and PNG.")
    private @Nullable Path figuresFolder;

    @Option(
            names = "replays",
            paramLabel = "WHICH",
            defaultValue = "all",
            completionCandidates = Replays.class,
            description = "Writes a replay of every champion (all), of the best of each experiment (best) or of none"
                    + " (none), into a folder beside the page (default: ${DEFAULT-VALUE}).")
    private String replays;

    @Mixin
    private TaskOption task;

    @Mixin
    private GhostsOption ghosts;

    @Mixin
    private JarOption jar;

    @Override
    public void run() {
        OutputFile.require("out", out);
        if (figuresFolder != null) {
            OutputFile.requireFolder("figures", figuresFolder);
        }
        List<Experiment> experiments = experimentsArgument.find(this);
        boolean published = experiments.stream().anyMatch(ReportCommand::isPublished);
        ExperimentReport report = new ExperimentReport(
                experiments,
                ExperimentComparison.ofEachVersion(experiments, ExperimentComparison.Scores.AUTO, published),
                jar.file());
        List<Figure> figures = report.figures();
        Path folder = figuresFolder;
        if (folder != null) {
            for (Figure figure : figures) {
                for (String ending : List.of(".svg", ".png")) {
                    OutputFile.requireOther(
                            "out", out, "a figure in figures=" + folder, folder.resolve(figure.name() + ending));
                }
            }
            for (Figure figure : figures) {
                OutputFile.write(folder.resolve(figure.name() + ".svg"), figure.svg());
                figure.png().ifPresent(png -> OutputFile.write(folder.resolve(figure.name() + ".png"), png));
            }
        }
        Map<Path, String> links = replays(experiments);
        String heading = title == null ? title(experiments) : title;
        OutputFile.write(out, report.html(heading, figures, (experiment, run) -> links.get(run.folder())));
        PrintWriter messages = out();
        messages.println(out + ": open it in a browser");
        if (figuresFolder != null && !MachineFonts.areAvailable()) {
            messages.println(figuresFolder + ": SVG only, no PNG: " + MachineFonts.MISSING);
        }
        messages.flush();
    }

    private static boolean isPublished(Experiment experiment) {
        return !experiment.isVariant()
                && !PublishedResults.read()
                        .champions(experiment.version(), experiment.paperMethod())
                        .isEmpty();
    }

    private static String title(List<Experiment> experiments) {
        List<String> versions =
                experiments.stream().map(Experiment::version).distinct().toList();
        String version = versions.size() == 1 ? MethodName.title(versions.get(0)) : "";
        return (version.isEmpty() ? "" : version + ": ")
                + String.join(", ", experiments.stream().map(Experiment::label).toList());
    }

    /** Writes the replays and returns the link to each by the run's folder. */
    private Map<Path, String> replays(List<Experiment> experiments) {
        String folder = out.getFileName().toString().replaceFirst("\\.html?$", "") + "-replays";
        Map<Path, String> links = new HashMap<>();
        for (Experiment experiment : experiments) {
            List<RunResult> runs =
                    switch (replays) {
                        case "all" -> experiment.runs();
                        case "best" -> List.of(experiment.best());
                        default -> List.of();
                    };
            for (RunResult run : runs) {
                Optional<String> replay = Champion.isIn(run.folder()) ? replay(experiment, run) : Optional.empty();
                if (replay.isPresent()) {
                    String name = (experiment.label() + "-" + run.number()).replaceAll("[^A-Za-z0-9]+", "-") + ".html";
                    OutputFile.write(out.resolveSibling(folder).resolve(name), replay.get());
                    links.put(run.folder(), folder + "/" + name);
                }
            }
        }
        return links;
    }

    /**
     * Writes the replay of a typical game: the game with the median score of the champion's evaluation, or game 0
     * without an evaluation. Returns empty if the champion was evolved for another task.
     */
    private Optional<String> replay(Experiment experiment, RunResult run) {
        Champion champion = jar.allow(Champion.read(run.folder()));
        return ghosts.findSettings(champion, task, Rules.TRAINING)
                .map(settings -> replay(champion, settings, experiment, run));
    }

    private static String replay(
            Champion champion, MsPacManTaskSettings settings, Experiment experiment, RunResult run) {
        long seed = ChampionEvaluator.typicalGame(champion, run.folder(), Rules.TRAINING)
                .orElse(0L);
        ReplayTitle title = new ReplayTitle(
                (experiment.version() + " " + experiment.method() + ", run " + run.number()).strip(),
                "training rules, seed " + seed + ", network "
                        + champion.genotype().id());
        return ReplayPage.html(GameRecording.record(settings, champion.genotype(), seed, title));
    }
}
