package mmneat.experiment.original;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import mmneat.evolution.Evaluation;
import mmneat.evolution.Evaluation.Outcomes;
import mmneat.evolution.Individual;
import mmneat.neat.ModuleLayout;
import mmneat.neat.variation.InitialNetworks;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;

/** Logs that the golden runs only cover in part. Source: docs/specification/evolution.md, section 5.2. */
class GenerationLogsTest {

    private static Individual individual(int modules, double score, Outcomes outcomes, long milliseconds) {
        return new Individual(
                new InitialNetworks(1, ModuleLayout.withPreferenceNeurons(modules, 1))
                        .create(0, new ResumableRandom(1)),
                new Evaluation(new double[] {0}, new double[] {score}, new int[modules], outcomes),
                milliseconds * 1_000_000);
    }

    private static Individual scored(int modules, double score) {
        return individual(modules, score, Outcomes.NONE, 0);
    }

    @Test
    void moduleCounts_networksOfMoreThanFiveModules_areCountedTogether() {
        List<Individual> parents = List.of(
                scored(1, 3),
                scored(1, 5),
                scored(5, 4),
                scored(6, 7),
                scored(7, 9),
                scored(12, 8),
                scored(2, 9),
                scored(9, 3));
        assertThat(ModuleCountLog.row(4, parents))
                .isEqualTo("4\t" + "7.0\t2.0\t4.5\t" + "9.0\t1.0\t5.0\t" + "5.0\t9.0\t0.0\t0.0\t4.0\t9.0\t\n");
    }

    @Test
    void moduleCounts_withoutNetworksOfMoreThanFiveModules_are0() {
        assertThat(ModuleCountLog.row(0, List.of(scored(5, 4))))
                .isEqualTo("0\t" + "5.0\t5.0\t5.0\t" + "5.0\t5.0\t5.0\t" + "0.0\t0.0\t0.0\t0.0\t4.0\t0.0\t\n");
    }

    @Test
    void costs_outcomesOfAll_areGivenToTheFirst() {
        List<double[]> costs = EvaluationCosts.of(
                List.of(
                        individual(1, 0, new Outcomes(1, 0, 2, 100), 40),
                        individual(1, 0, new Outcomes(0, 3, 1, 100), 10),
                        individual(1, 0, new Outcomes(2, 1, 0, 100), 30)),
                4);
        assertThat(costs.toArray(double[][]::new)).isDeepEqualTo(new double[][] {
            {40, 10, 4, 3, 4, 3},
            {10, 2.5, 4, 0, 0, 0},
            {30, 7.5, 4, 0, 0, 0}
        });
    }
}
