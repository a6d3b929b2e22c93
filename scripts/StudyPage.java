import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.DoublePredicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import mmneat.analysis.ExperimentComparison;
import mmneat.analysis.evaluation.Rules;
import mmneat.analysis.figures.Figure;
import mmneat.analysis.figures.LearningCurveFigure;
import mmneat.analysis.figures.ModuleUseFigure;
import mmneat.analysis.results.ChampionEvaluation;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.ExperimentFinder;
import mmneat.analysis.results.PublishedResults;
import mmneat.analysis.results.RunReader;
import mmneat.analysis.results.RunResult;
import mmneat.analysis.statistics.Numbers;
import mmneat.analysis.statistics.Sample;

/**
 * Writes the numbers and pictures of docs/reproduction.md from the runs in docs/study: everything between the two
 * marks. Started by {@code scripts/study page}.
 */
public final class StudyPage {

    private static final String BEGIN = "<!-- From here on made by scripts/study page. -->\n";
    private static final String END = "<!-- To here. -->\n";

    /** The sample size of the paper. */
    private static final int RUNS_OF_THE_PAPER = 30;

    /** A champion whose most used module decides at least this share of the steps has one main module. */
    private static final double MAIN_MODULE_PERCENT = 90;

    /** The line under the head of a table with up to eight columns. */
    private static final String[] DASHES =
            IntStream.range(0, 8).mapToObj(i -> "---").toArray(String[]::new);

    private final StringBuilder text = new StringBuilder();
    private final PublishedResults paper = PublishedResults.read();

    /** @param arguments the folder of the study, the page, and the folder of the pictures */
    public static void main(String[] arguments) throws IOException {
        Path page = Path.of(arguments[1]);
        String old = Files.readString(page);
        StudyPage study = new StudyPage();
        study.write(Path.of(arguments[0]), Path.of(arguments[2]));
        Files.writeString(
                page,
                old.substring(0, old.indexOf(BEGIN))
                        + BEGIN
                        + study.text
                        + END
                        + old.substring(old.indexOf(END) + END.length()));
    }

    private void write(Path folder, Path pictures) throws IOException {
        for (Path version : folders(folder)) {
            List<Experiment> experiments = ExperimentFinder.find(List.of(version));
            String name = version.getFileName().toString();
            text.append("\n## The ").append(name).append(" version\n\n");
            overview(experiments);
            moduleUse(experiments);
            champions(experiments);
            otherRules(experiments);
            for (ExperimentComparison comparison :
                    ExperimentComparison.ofEachVersion(experiments, ExperimentComparison.Scores.AUTO, true)) {
                text.append("\nThe tests of `compare docs/study/" + name + " paper=true`:\n\n");
                comparison.report().text().lines().forEach(line -> text.append(("    " + line).stripTrailing() + "\n"));
                comparison
                        .notes()
                        .forEach(note -> text.append("\n* ").append(note).append('\n'));
            }
            List<Figure> figures = new ArrayList<>();
            figures.add(LearningCurveFigure.panels(name, experiments, paper));
            ModuleUseFigure.of(name, experiments, paper).ifPresent(figures::add);
            for (Figure figure : figures) {
                String file = "study-" + figure.name() + ".svg";
                Files.writeString(pictures.resolve(file), figure.svg());
                text.append("\n![" + figure.caption() + "](" + pictures.getFileName() + "/" + file + ")\n");
            }
        }
    }

    private void overview(List<Experiment> experiments) {
        row(
                "method",
                "runs",
                "missing to the paper's " + RUNS_OF_THE_PAPER,
                "median",
                "quartiles",
                "the paper's median",
                "quartiles");
        row(Arrays.copyOf(DASHES, 7));
        for (Experiment experiment : experiments) {
            double[] ours = experiment.championScores(true);
            if (ours.length > 0) {
                double[] theirs = publishedScores(experiment, percent -> true);
                row(
                        experiment.label(),
                        "" + ours.length,
                        "" + Math.max(0, RUNS_OF_THE_PAPER - ours.length),
                        median(ours),
                        quartiles(ours),
                        median(theirs),
                        quartiles(theirs));
            }
        }
    }

    /** The clusters of the paper's picture: champions with one main module, and those that use several. */
    private void moduleUse(List<Experiment> experiments) {
        text.append("\nChampions with one main module (it decides at least " + Numbers.decimal(MAIN_MODULE_PERCENT, 0)
                + " % of the steps) and the others:\n\n");
        row("method", "main module", "runs", "median", "quartiles", "in the paper", "median", "quartiles");
        row(Arrays.copyOf(DASHES, 8));
        for (Experiment experiment : experiments) {
            for (boolean hasMainModule : new boolean[] {true, false}) {
                DoublePredicate cluster = percent -> percent >= MAIN_MODULE_PERCENT == hasMainModule;
                double[] ours = experiment.runs().stream()
                        .filter(RunResult::isComparable)
                        .map(run -> run.evaluation().orElseThrow())
                        .filter(evaluation -> cluster.test(evaluation.mostUsedModulePercent()))
                        .mapToDouble(ChampionEvaluation::meanScore)
                        .toArray();
                double[] theirs = publishedScores(experiment, cluster);
                if (ours.length + theirs.length > 0) {
                    row(
                            experiment.label(),
                            hasMainModule ? "yes" : "no",
                            "" + ours.length,
                            median(ours),
                            quartiles(ours),
                            "" + theirs.length,
                            median(theirs),
                            quartiles(theirs));
                }
            }
        }
    }

    /** Returns the scores of the paper's champions whose percentage for the most used module is in the cluster. */
    private double[] publishedScores(Experiment experiment, DoublePredicate cluster) {
        return paper.champions(experiment.version(), experiment.method()).stream()
                .filter(champion -> cluster.test(champion.mostUsedModulePercent()))
                .mapToDouble(PublishedResults.Champion::averageScore)
                .toArray();
    }

    private static String median(double[] scores) {
        return scores.length == 0 ? "" : Numbers.score(new Sample("", scores).median());
    }

    private static String quartiles(double[] scores) {
        if (scores.length == 0) {
            return "";
        }
        Sample sample = new Sample("", scores);
        return Numbers.score(sample.quantile(0.25)) + " to " + Numbers.score(sample.quantile(0.75));
    }

    private void champions(List<Experiment> experiments) {
        text.append("\nChampions, each over its games under training rules:\n\n");
        row(
                "champion",
                "when chosen",
                "games",
                "mean score",
                "95 % interval",
                "most used module",
                "deaths in mazes A, B, C, D");
        row(Arrays.copyOf(DASHES, 7));
        for (Experiment experiment : experiments) {
            for (RunResult run : experiment.runs()) {
                if (run.isComparable()) {
                    ChampionEvaluation evaluation = run.evaluation().orElseThrow();
                    row(
                            experiment.label() + ", run " + run.number(),
                            Numbers.score(run.scoreOfChampion()),
                            String.format(Locale.ROOT, "%,d", evaluation.games()),
                            Numbers.score(evaluation.meanScore()),
                            Numbers.score(evaluation.low()) + " to " + Numbers.score(evaluation.high()),
                            Numbers.decimal(evaluation.mostUsedModulePercent(), 1) + " %",
                            Arrays.stream(evaluation.deathsByMaze())
                                    .mapToObj(Long::toString)
                                    .collect(Collectors.joining(", ")));
                }
            }
        }
    }

    /** Champions that were also evaluated under other rules. */
    private void otherRules(List<Experiment> experiments) {
        List<String[]> rows = new ArrayList<>();
        for (Experiment experiment : experiments) {
            for (RunResult run : experiment.runs()) {
                for (Rules rules : List.of(Rules.FOUR_MAZE, Rules.MPM_VS_GHOSTS)) {
                    RunReader.evaluation(run.folder(), rules.label())
                            .ifPresent(evaluation -> rows.add(new String[] {
                                experiment.label() + ", run " + run.number(),
                                rules.label(),
                                String.format(Locale.ROOT, "%,d", evaluation.games()),
                                Numbers.score(evaluation.meanScore()),
                                Numbers.score(evaluation.low()) + " to " + Numbers.score(evaluation.high())
                            }));
                }
            }
        }
        if (rows.isEmpty()) {
            return;
        }
        text.append("\nChampions under the rules of other games (`evaluate rules=FourMaze` and"
                + " `rules=MPMvsG`: three lives\nand an extra one):\n\n");
        row("champion", "rules", "games", "mean score", "95 % interval");
        row(Arrays.copyOf(DASHES, 5));
        rows.forEach(this::row);
    }

    private void row(String... cells) {
        text.append("| ").append(String.join(" | ", cells)).append(" |\n");
    }

    private static List<Path> folders(Path parent) throws IOException {
        try (var entries = Files.list(parent)) {
            return entries.filter(Files::isDirectory).sorted().toList();
        }
    }
}
