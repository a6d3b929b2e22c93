package mmneat.analysis.results;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * Runs that differ in nothing but the seed.
 *
 * @param version blended, interleaved, isolated, or empty for a task of the user's own
 * @param method 1M, 2M, 3M, MMD, MT, MT2, MT3, or what the folder is called
 * @param label how tables and figures call it, unique among the experiments read together
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

    /** Whether every champion was evaluated after evolution. */
    public boolean isEvaluated() {
        return runs.stream().allMatch(run -> run.evaluation().isPresent());
    }

    /** Each run's champion score: of its evaluation, or of the last generation. */
    public double[] championScores(boolean evaluated) {
        return runs.stream()
                .mapToDouble(run -> evaluated ? run.evaluation().orElseThrow().meanScore() : run.lastScore())
                .toArray();
    }

    /** The run with the best champion: by its evaluation, or without one by the last generation. */
    public RunResult best() {
        return runs.stream()
                .max(Comparator.comparingDouble(run ->
                        run.evaluation().map(ChampionEvaluation::meanScore).orElse(run.lastScore())))
                .orElseThrow();
    }

    /** The shortest run's number of generations; curves over all runs end there. */
    public int generations() {
        return runs.stream().mapToInt(RunResult::generations).min().orElseThrow();
    }

    /** All runs' champion scores in a generation. */
    public double[] championScoresAt(int generation) {
        return runs.stream()
                .mapToDouble(run -> run.championScores()[generation])
                .toArray();
    }
}
