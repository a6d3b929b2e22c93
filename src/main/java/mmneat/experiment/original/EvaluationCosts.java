package mmneat.experiment.original;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import mmneat.evolution.Evaluation.Outcomes;
import mmneat.evolution.Individual;

/**
 * The values of the Performance log for the evaluations of a generation: times, and how trials ended.
 *
 * <p>Source: docs/specification/evolution.md, section 5.2.
 */
final class EvaluationCosts {

    static final List<String> LABELS = List.of(
            "Total Eval Time",
            "Average Eval Time",
            "Trials",
            "Times All Levels Beaten",
            "Times Time Limit Reached",
            "Times Died");

    private EvaluationCosts() {}

    /** Returns the costs of each individual. */
    static List<double[]> of(List<Individual> individuals, int trials) {
        // The original counts how trials end in counters of the whole generation and reads them at the first
        // individual.
        Outcomes all = individuals.stream()
                .map(individual -> individual.evaluation().outcomes())
                .reduce(Outcomes.NONE, Outcomes::plus);
        List<double[]> costs = new ArrayList<>(individuals.size());
        for (Individual individual : individuals) {
            double milliseconds = TimeUnit.NANOSECONDS.toMillis(individual.nanoseconds());
            Outcomes outcomes = costs.isEmpty() ? all : Outcomes.NONE;
            costs.add(new double[] {
                milliseconds,
                milliseconds / trials,
                trials,
                outcomes.succeeded(),
                outcomes.timedOut(),
                outcomes.failed()
            });
        }
        return costs;
    }
}
