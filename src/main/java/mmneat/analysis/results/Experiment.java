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
 * @param method 1M, 2M, 3M, MMD, MT, MT2, MT3, or the name of the folder
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
     * How the parameters differ from the paper's for the same version and method, by name: the paper's values. Empty
     * also for what the paper does not have.
     */
    public Map<String, String> differencesFromPaper() {
        Optional<TaskVersion> published = TaskVersion.labelled(version)
                .filter(task -> PublishedConfigurations.methodsOf(task).contains(method));
        return published
                .map(task -> PublishedTask.differences(task, method, runs.get(0).parameters()))
                .orElse(Map.of());
    }

    /** Whether this is a variant of the paper's method: a parameter that defines the method has another value. */
    public boolean isVariant() {
        return PublishedTask.changesTheMethod(differencesFromPaper().keySet());
    }

    /** The name of the method in the paper, under which the paper's results are found; empty for a variant. */
    public String paperMethod() {
        return isVariant() ? "" : MethodName.paper(method);
    }

    /**
     * The champion scores of the runs that can be compared.
     *
     * @param evaluated whether to take the evaluations of the runs that are finished and evaluated, or the last
     *     generations of those that are finished
     */
    public double[] championScores(boolean evaluated) {
        return runs.stream()
                .filter(run -> evaluated ? run.isComparable() : !run.isUnfinished())
                .mapToDouble(run -> evaluated ? run.evaluation().orElseThrow().meanScore() : run.lastScore())
                .toArray();
    }

    /**
     * The run with the best champion: by its evaluation, if a finished run has one; if none has, by the score with
     * which it was chosen.
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

    /** Generations that the curves over all runs cover: those of the shortest finished run. */
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
