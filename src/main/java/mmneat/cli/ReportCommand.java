package mmneat.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
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
import mmneat.analysis.results.ExperimentFinder;
import mmneat.analysis.results.MethodName;
import mmneat.analysis.results.PublishedResults;
import mmneat.analysis.results.RunResult;
import mmneat.experiment.FileErrors;
import mmneat.experiment.UserError;
import mmneat.mspacman.MsPacManTaskSettings;
import pacman.game.MachineFonts;
import picocli.CommandLine.Command;

/** Writes one page about a set of experiments, with its figures and replays. */
@Command(
        name = "report",
        customSynopsis = "mmneat report EXPERIMENT... [name=value...]",
        description = {
            "Writes one web page about experiments: figures, statistics, champions with their networks and replays, settings."
                    + " It needs no server and no network.",
            "",
            "Example: mmneat report results/blended out=blended.html",
            "Example: mmneat report results/blended results/isolated figures=pictures replays=best",
            "",
        })
final class ReportCommand extends WordCommand implements Runnable {

    @Override
    List<Word> knownWords() {
        return List.of(
                new Word("out", "FILE", "the page to write (default report.html)"),
                new Word("title", "TEXT", "its heading (default: the experiments)"),
                new Word("figures", "FOLDER", "also writes the figures there, as SVG and PNG"),
                new Word(
                        "replays",
                        "all|best|none",
                        "writes a replay of every champion, of the best of each experiment, or of none, into a folder beside"
                                + " the page (default all)"),
                new Word("task", "blended", "version of the task, where the runs do not say it themselves"),
                new Word("ghosts", "FILE", "recorded ghost locations, for replays of the isolated version"));
    }

    @Override
    public void run() {
        Words words = wordsAboutExperiments();
        List<Experiment> experiments = ExperimentFinder.find(experimentPaths(words));
        boolean published = experiments.stream().anyMatch(ReportCommand::isPublished);
        ExperimentReport report = new ExperimentReport(
                experiments,
                ExperimentComparison.ofEachVersion(experiments, ExperimentComparison.Scores.AUTO, published));
        Path out = words.path("out").orElse(Path.of("report.html"));
        List<Figure> figures = report.figures();
        words.path("figures").ifPresent(folder -> {
            for (Figure figure : figures) {
                OutputFile.write(folder.resolve(figure.name() + ".svg"), figure.svg());
                figure.png().ifPresent(png -> OutputFile.write(folder.resolve(figure.name() + ".png"), png));
            }
        });
        Map<Path, String> links = replays(words, experiments, out);
        String title = words.text("title", title(experiments));
        OutputFile.write(out, report.html(title, figures, (experiment, run) -> links.get(run.folder())));
        PrintWriter messages = out();
        messages.println(out + ": open it in a browser");
        if (words.has("figures") && !MachineFonts.areAvailable()) {
            messages.println(words.text("figures", "") + ": SVG only, no PNG: " + MachineFonts.MISSING);
        }
        messages.flush();
    }

    private static boolean isPublished(Experiment experiment) {
        return !PublishedResults.read()
                .champions(experiment.version(), experiment.method())
                .isEmpty();
    }

    private static String title(List<Experiment> experiments) {
        List<String> versions =
                experiments.stream().map(Experiment::version).distinct().toList();
        String version = versions.size() == 1 ? MethodName.title(versions.get(0)) : "";
        return (version.isEmpty() ? "" : version + ": ")
                + String.join(", ", experiments.stream().map(Experiment::label).toList());
    }

    /** Writes the replays and gives the link to each, by the run's folder. */
    private Map<Path, String> replays(Words words, List<Experiment> experiments, Path out) {
        String which = words.choice("replays", "all", List.of("all", "best", "none"));
        String folder = out.getFileName().toString().replaceFirst("\\.html?$", "") + "-replays";
        Map<Path, String> links = new HashMap<>();
        for (Experiment experiment : experiments) {
            List<RunResult> runs =
                    switch (which) {
                        case "all" -> experiment.runs();
                        case "best" -> List.of(experiment.best());
                        default -> List.of();
                    };
            for (RunResult run : runs) {
                Optional<String> replay =
                        Champion.isIn(run.folder()) ? replay(words, experiment, run) : Optional.empty();
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
     * A typical game: that of median score in the champion's evaluation, or else game 0; none if the champion was evolved for
     * another task.
     */
    private static Optional<String> replay(Words words, Experiment experiment, RunResult run) {
        Champion champion = Champion.read(run.folder());
        return ChampionWords.findSettings(words, champion, Rules.TRAINING)
                .map(settings -> replay(champion, settings, experiment, run));
    }

    private static String replay(
            Champion champion, MsPacManTaskSettings settings, Experiment experiment, RunResult run) {
        long seed;
        try {
            seed = ChampionEvaluator.typicalGame(champion, run.folder(), Rules.TRAINING)
                    .orElse(0L);
        } catch (IOException e) {
            throw new UserError(run.folder() + ": " + FileErrors.reason(e), e);
        }
        ReplayTitle title = new ReplayTitle(
                (experiment.version() + " " + experiment.method() + ", run " + run.number()).strip(),
                "training rules, seed " + seed + ", network "
                        + champion.genotype().id());
        return ReplayPage.html(GameRecording.record(settings, champion.genotype(), seed, title));
    }
}
