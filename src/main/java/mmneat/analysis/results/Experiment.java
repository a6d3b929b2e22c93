package mmneat.analysis.results;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import mmneat.experiment.parameters.PublishedConfigurations;
import mmneat.experiment.parameters.PublishedTask;
import mmneat.mspacman.TaskVersion;

/**
 * Runs that differ only in the seed.
 *
 * @param version blended, interleaved, isolated, or empty for a task of the user's own
 * @param method name of the method that the parameters define, such as {@code 2M} ({@link mmneat.experiment} explains
 *     the names); for parameters without a named method, the name of the runs' folders without the number
 * @param label name in tables and figures, unique among the experiments read together
 * @param runs its runs in the order of their numbers, at least one
 */
public record Experiment(String version, String method, String label, List<RunResult> runs) {

    public Experiment {
        runs = List.copyOf(runs);
    }

    /** Experiments by the version of the task, in their order. */
    public static Map<String, List<Experiment>> byVersion(List<Experiment> experiments) {
        return experiments.stream()
                .collect(Collectors.groupingBy(Experiment::version, LinkedHashMap::new, Collectors.toList()));
    }

    /**
     * Returns the parameters whose values differ from those of the paper's experiment with the same version and method.
     * Of the runs of this experiment the first one is compared.
     *
     * @return the paper's value by the name of the parameter, only for parameters that differ; empty also if the paper
     *     has no experiment with this version and method
     */
    public Map<String, String> differencesFromPaper() {
        Optional<TaskVersion> published = TaskVersion.labelled(version)
                .filter(task -> PublishedConfigurations.methodsOf(task).contains(method));
        return published
                .map(task -> PublishedTask.differences(task, method, runs.get(0).parameters()))
                .orElse(Map.of());
    }

    /**
     * Whether this is a variant of the paper's method of the same name, which must not stand under that name: a
     * parameter named by {@link PublishedTask#changesTheMethod} differs from the paper's, such as the sensors or the
     * number of lives.
     */
    public boolean isVariant() {
        return PublishedTask.changesTheMethod(differencesFromPaper().keySet());
    }

    /** The name of the method in the paper, under which the paper's results are found; empty for a variant. */
    public String paperMethod() {
        return isVariant() ? "" : MethodName.paper(method);
    }

    /**
     * Returns one score per run. Unfinished runs are left out.
     *
     * @param evaluated if true, the mean scores of the evaluations after evolution, and runs without an evaluation are
     *     left out, too; if false, each run's {@link RunResult#lastScore}
     */
    public double[] championScores(boolean evaluated) {
        return scored(evaluated)
                .mapToDouble(run -> evaluated ? run.evaluation().orElseThrow().meanScore() : run.lastScore())
                .toArray();
    }

    /** This experiment with only the runs that have a score in {@link #championScores}. */
    public Experiment ofScoredRuns(boolean evaluated) {
        return new Experiment(version, method, label, scored(evaluated).toList());
    }

    private Stream<RunResult> scored(boolean evaluated) {
        return runs.stream().filter(run -> evaluated ? run.isComparable() : !run.isUnfinished());
    }

    /**
     * Returns the run with the best champion. If at least one finished run has an evaluation, only such runs are
     * candidates, and the best mean score of an evaluation decides. Otherwise all runs are candidates, and the best
     * {@link RunResult#scoreOfChampion} decides.
     */
    public RunResult best() {
        return runs.stream()
                .filter(RunResult::isComparable)
                .max(Comparator.comparingDouble(
                        run -> run.evaluation().orElseThrow().meanScore()))
                .orElseGet(() -> runs.stream()
                        .max(Comparator.comparingDouble(RunResult::scoreOfChampion))
                        .orElseThrow());
    }

    /**
     * Number of generations that the curves over all runs cover: those evolved by the shortest finished run, or by the
     * shortest run if none is finished. It is also the last generation that {@link #championScoresAt} accepts, because
     * the final parents have scores, too.
     */
    public int generations() {
        return finishedOrAll().mapToInt(RunResult::generations).min().orElseThrow();
    }

    /** The champion scores of the finished runs in a generation; of all runs if none is finished. */
    public double[] championScoresAt(int generation) {
        return finishedOrAll()
                .mapToDouble(run -> run.championScores()[generation])
                .toArray();
    }

    private Stream<RunResult> finishedOrAll() {
        boolean isAnyFinished = runs.stream().anyMatch(run -> !run.isUnfinished());
        return runs.stream().filter(run -> !isAnyFinished || !run.isUnfinished());
    }
}
