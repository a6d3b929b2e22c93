package mmneat.experiment.original;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import mmneat.evolution.Evaluation;
import mmneat.evolution.Individual;
import mmneat.experiment.store.DoubleText;

/**
 * Formats scores of individuals as the lines of the original's score files.
 *
 * <p>Source: docs/specification/evolution.md, sections 1.3 and 5.1.
 */
final class ScoreTables {

    private ScoreTables() {}

    /** Returns one line per individual: index, id, scores. */
    static String of(List<Individual> individuals, Function<Evaluation, double[]> scores) {
        List<String> lines = new ArrayList<>(individuals.size());
        for (Individual individual : individuals) {
            lines.add(lines.size() + "\t" + individual.genotype().id() + "\t"
                    + PopulationLog.tabbed(scores.apply(individual.evaluation())) + "\n");
        }
        return String.join("", lines);
    }

    /** Returns all scores of one individual, as the original prints them. */
    static String line(Individual individual) {
        Evaluation evaluation = individual.evaluation();
        return individual.genotype().id() + ":N=1:" + list(evaluation.objectives()) + list(evaluation.otherScores())
                + "\n";
    }

    private static String list(double[] values) {
        return Arrays.stream(values).mapToObj(DoubleText::of).collect(Collectors.joining(", ", "[", "]"));
    }
}
