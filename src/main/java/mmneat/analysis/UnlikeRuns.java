package mmneat.analysis;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import mmneat.analysis.results.ChampionEvaluation;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.RunResult;
import mmneat.experiment.parameters.PublishedTask;

/** Remarks on runs that are compared although their settings or their evaluations differ. */
final class UnlikeRuns {

    /** Maximum number of runs with a common value that are named; of more, only the number is told. */
    private static final int MOST_NAMED = 4;

    private final List<Experiment> experiments;

    /** For experiments of one version of the task, with only those runs that are compared. */
    UnlikeRuns(List<Experiment> experiments) {
        this.experiments = experiments;
    }

    /** Remarks on the parameters: one per experiment whose runs differ, and one if the experiments differ. */
    List<String> ofParameters() {
        List<String> notes = new ArrayList<>();
        for (Experiment experiment : experiments) {
            Map<String, RunResult> runs = new LinkedHashMap<>();
            experiment.runs().forEach(run -> runs.put("run " + run.number(), run));
            describe(runs, PublishedTask.differing(parameters(runs)), notes, "The runs of " + experiment.label());
        }
        Map<String, RunResult> first = new LinkedHashMap<>();
        experiments.forEach(
                experiment -> first.put(experiment.label(), experiment.runs().get(0)));
        List<String> names = PublishedTask.differing(parameters(first)).stream()
                .filter(name -> !PublishedTask.changesTheMethod(List.of(name)))
                .toList();
        describe(first, names, notes, "The methods");
        return notes;
    }

    private static List<Map<String, String>> parameters(Map<String, RunResult> runs) {
        return runs.values().stream().map(RunResult::parameters).toList();
    }

    private static void describe(Map<String, RunResult> runs, List<String> names, List<String> notes, String which) {
        if (!names.isEmpty()) {
            notes.add(which + " have different settings: "
                    + names.stream()
                            .map(name -> values(
                                    runs, run -> name + "=" + run.parameters().getOrDefault(name, "(not given)")))
                            .collect(Collectors.joining("; "))
                    + ".");
        }
    }

    /** For example "mu=4 (30 of them), mu=10 (run 2)". */
    private static String values(Map<String, RunResult> runs, Function<RunResult, String> value) {
        Map<String, List<String>> namesByValue = new LinkedHashMap<>();
        runs.forEach((name, run) -> namesByValue
                .computeIfAbsent(value.apply(run), key -> new ArrayList<>())
                .add(name));
        return namesByValue.entrySet().stream()
                .map(entry -> entry.getKey() + " (" + text(entry.getValue()) + ")")
                .collect(Collectors.joining(", "));
    }

    private static String text(List<String> names) {
        return names.size() > MOST_NAMED ? names.size() + " of them" : String.join(", ", names);
    }

    /** A remark if the evaluations have different numbers of games or different seeds, as far as these are known. */
    List<String> ofEvaluations() {
        Map<String, RunResult> runs = new LinkedHashMap<>();
        for (Experiment experiment : experiments) {
            experiment.runs().forEach(run -> runs.put(experiment.label() + " run " + run.number(), run));
        }
        boolean areAlike =
                evaluations(runs).map(ChampionEvaluation::games).distinct().count() <= 1
                        && evaluations(runs)
                                        .flatMap(evaluation -> Stream.ofNullable(evaluation.seed()))
                                        .distinct()
                                        .count()
                                <= 1;
        return areAlike
                ? List.of()
                : List.of("The champions were evaluated differently: "
                        + values(runs, run -> text(run.evaluation().orElseThrow())) + ".");
    }

    private static Stream<ChampionEvaluation> evaluations(Map<String, RunResult> runs) {
        return runs.values().stream().flatMap(run -> run.evaluation().stream());
    }

    private static String text(ChampionEvaluation evaluation) {
        return evaluation.games() + " games with "
                + (evaluation.seed() == null ? "an unknown seed" : "seed " + evaluation.seed());
    }
}
