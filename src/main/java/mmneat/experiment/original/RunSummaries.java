package mmneat.experiment.original;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import mmneat.evolution.SampleStatistics;
import mmneat.evolution.Task;
import mmneat.experiment.TextFiles;
import mmneat.experiment.UserError;
import mmneat.experiment.store.DoubleText;
import mmneat.experiment.store.OrdinaryFiles;
import mmneat.experiment.store.RunFolder;
import mmneat.experiment.store.RunLayout;
import mmneat.nsga2.Hypervolume;

/**
 * Summaries over the runs of an experiment: hypervolumes, logs averaged over runs, and the gnuplot scripts that show
 * them.
 *
 * <p>Unlike in the original, the averages include all generations that all runs have.
 *
 * <p>Source: docs/specification/evolution.md, section 7.
 */
public final class RunSummaries {

    private static final String PARENTS_LOG = RunLayout.log("", RunLayout.PARENTS);
    private static final String NETWORKS_LOG = RunLayout.log("", RunLayout.NETWORKS);
    private static final String PERFORMANCE_LOG = RunLayout.log("", RunLayout.PERFORMANCE);
    private static final String HYPERVOLUMES = "parents_genHV";

    private final Path base;
    private final String saveTo;
    private final String log;
    private final Task task;
    private final RunFolder output;

    /**
     * Creates the summaries of an experiment.
     *
     * @param base folder with the folders of the runs, where the summaries are written
     * @param saveTo name of the runs' folders, without the run number
     * @param log prefix of their files' names, without the run number
     * @param task the task of the runs
     */
    public RunSummaries(Path base, String saveTo, String log, Task task) {
        this.base = base;
        this.saveTo = saveTo;
        this.log = log;
        this.task = task;
        output = new RunFolder(base, log);
    }

    /**
     * Writes the summaries of these runs.
     *
     * @throws UserError if a run's file cannot be read or has invalid numbers; the message names it
     * @throws java.io.UncheckedIOException if a summary cannot be written
     */
    public void write(List<Integer> runs) {
        runs.forEach(run -> OrdinaryFiles.requireIn(folderOf(run).directory()));
        writeHypervolumes(runs);
        writeAverages(runs, HYPERVOLUMES + ".txt");
        writeHypervolumePlots(runs);
        writeAverages(runs, PARENTS_LOG);
        writeAverages(runs, NETWORKS_LOG);
        writeAverages(runs, PERFORMANCE_LOG);
        writeSpreadPlot("parents_genScores", PARENTS_LOG, quoted(scoreLabels()));
        writeSpreadPlot("TWEANNData_log", NETWORKS_LOG, NetworkProperties.labels(task.inputLabels()));
        writeSpreadPlot("Performance_log", PERFORMANCE_LOG, EvaluationCosts.LABELS);
        output.flush();
    }

    /**
     * Writes for each run one row per generation: the hypervolume of the parents and the size of their Pareto front.
     * {@link #write} includes this.
     */
    public void writeHypervolumes(List<Integer> runs) {
        for (int run : runs) {
            RunFolder folder = folderOf(run);
            int generations = rows(run, RunLayout.log("", RunLayout.CHILDREN)).size();
            StringBuilder lines = new StringBuilder();
            int population = 0;
            for (int generation = 0; generation < generations; generation++) {
                List<double[]> parents = rows(run, RunLayout.scores("", RunLayout.PARENTS, generation));
                population = generation == 0 ? parents.size() : population;
                requireScores(run, generation, parents, population);
                double[][] scores = parents.stream()
                        .map(row -> Arrays.copyOfRange(row, 2, row.length))
                        .toArray(double[][]::new);
                lines.append(generation).append('\t');
                lines.append(DoubleText.of(Hypervolume.of(scores, task.referencePoint())))
                        .append('\t');
                lines.append(Hypervolume.frontSize(scores)).append('\n');
            }
            folder.write(folder.prefix() + HYPERVOLUMES + ".txt", lines.toString());
            folder.flush();
        }
    }

    /**
     * Checks that a file of scores is complete: as many parents as in generation 0, and a finite score in each
     * objective.
     */
    private void requireScores(int run, int generation, List<double[]> parents, int population) {
        int columns = 2 + task.objectiveNames().size();
        boolean areWhole = parents.stream()
                .allMatch(row -> row.length == columns && Arrays.stream(row).allMatch(Double::isFinite));
        if (parents.isEmpty() || parents.size() != population || !areWhole) {
            Path file = path(run, RunLayout.scores("", RunLayout.PARENTS, generation));
            throw new UserError(file + ": is damaged: must have a row of " + columns
                    + " finite numbers for each of the " + Math.max(1, population) + " parents, has " + parents.size()
                    + (areWhole ? " such" : "") + " rows");
        }
    }

    /** Writes the averages of a log: each column becomes two, mean and variance over the runs. */
    private void writeAverages(List<Integer> runs, String file) {
        List<List<double[]>> ofRuns = runs.stream().map(run -> rows(run, file)).toList();
        requireSameColumns(runs, file, ofRuns);
        int common = ofRuns.stream().mapToInt(List::size).min().orElse(0);
        StringBuilder lines = new StringBuilder();
        for (int i = 0; i < common; i++) {
            int row = i;
            for (int column = 0; column < ofRuns.get(0).get(row).length; column++) {
                int c = column;
                double[] sample =
                        ofRuns.stream().mapToDouble(rows -> rows.get(row)[c]).toArray();
                lines.append(
                        PopulationLog.tabbed(SampleStatistics.meanOf(sample), SampleStatistics.varianceOf(sample)));
            }
            lines.append('\n');
        }
        output.write(log + "AVG_" + file, lines.toString());
    }

    private void requireSameColumns(List<Integer> runs, String file, List<List<double[]>> ofRuns) {
        int columns = ofRuns.stream()
                .flatMap(List::stream)
                .findFirst()
                .map(row -> row.length)
                .orElse(0);
        for (int i = 0; i < ofRuns.size(); i++) {
            List<double[]> rows = ofRuns.get(i);
            if (rows.isEmpty() || rows.stream().anyMatch(row -> row.length != columns)) {
                throw new UserError(path(runs.get(i), file) + ": is damaged: "
                        + (rows.isEmpty() ? "it is empty" : "its rows do not all have " + columns + " columns"));
            }
        }
    }

    private void writeHypervolumePlots(List<Integer> runs) {
        PlotScript all = new PlotScript("set style data lines", "set key left")
                .picture("Hypervolumes for " + saveTo + " by Generation", curvesOfRuns(runs, 2))
                .line("")
                .picture("Pareto Front Size for " + saveTo + " by Generation", curvesOfRuns(runs, 3));
        output.write(log + "All_" + HYPERVOLUMES + ".plot", all.toString());

        String averages = log + "AVG_" + HYPERVOLUMES + ".txt";
        PlotScript average = new PlotScript("set style data lines", "set key left")
                .picture(
                        "Average Hypervolume for " + saveTo + " by Generation",
                        List.of(new PlotScript.Curve(averages, meanColumn(2), saveTo)))
                .line("set yrange [0:]")
                .picture(
                        "Average Pareto Front Size for " + saveTo + " by Generation",
                        List.of(new PlotScript.Curve(averages, meanColumn(3), saveTo)));
        output.write(log + "AVG_" + HYPERVOLUMES + ".plot", average.toString());
    }

    private List<PlotScript.Curve> curvesOfRuns(List<Integer> runs, int column) {
        return runs.stream()
                .map(run -> new PlotScript.Curve(
                        saveTo + run + "/" + log + run + "_" + HYPERVOLUMES + ".txt", column, saveTo + run))
                .toList();
    }

    private void writeSpreadPlot(String name, String file, List<String> labels) {
        PlotScript script = new PlotScript("set style data lines", "set key left");
        for (int property = 0; property < labels.size(); property++) {
            int column = RunLayout.firstColumn(property);
            script.picture(
                            "Average " + labels.get(property) + " for " + saveTo + " by Generation",
                            PlotScript.spread(
                                    log + "AVG_" + file,
                                    meanColumn(column),
                                    meanColumn(column + 1),
                                    meanColumn(column + 2)))
                    .line("");
        }
        output.write(log + "AVG_" + name + ".plot", script.toString());
    }

    /** Returns the column of the averages with the mean of a log's column; both are counted from 1. */
    private static int meanColumn(int column) {
        return 2 * column - 1;
    }

    private List<String> scoreLabels() {
        return Stream.concat(task.objectiveNames().stream(), task.otherScoreLabels().stream())
                .toList();
    }

    private static List<String> quoted(List<String> labels) {
        return labels.stream().map(label -> "'" + label + "'").toList();
    }

    private RunFolder folderOf(int run) {
        return new RunFolder(base.resolve(saveTo + run), log + run + "_");
    }

    private Path path(int run, String file) {
        RunFolder folder = folderOf(run);
        return folder.directory().resolve(folder.prefix() + file);
    }

    private List<double[]> rows(int run, String file) {
        Path path = path(run, file);
        List<String> lines = TextFiles.lines(path);
        List<double[]> rows = new ArrayList<>(lines.size());
        IntStream.range(0, lines.size()).forEach(i -> rows.add(numbers(path, i, lines.get(i))));
        return rows;
    }

    private static double[] numbers(Path file, int index, String line) {
        try {
            return Arrays.stream(line.split("\t"))
                    .mapToDouble(Double::parseDouble)
                    .toArray();
        } catch (NumberFormatException e) {
            throw new UserError(file + ", line " + (index + 1) + ": not a row of numbers: " + line, e);
        }
    }
}
