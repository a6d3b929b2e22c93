package mmneat.evolution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.neat.variation.InitialNetworks;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The generator of each evaluation, observed through a task whose score is the first number drawn. */
class ParallelEvaluatorTest {

    private static final int POPULATION = 5;

    private final Genotype genotype = new InitialNetworks(1, ModuleLayout.single(1)).create(0, new ResumableRandom(1));

    @Test
    void everyEvaluation_hasItsOwnGenerator_overParentsChildrenGenerationsAndRuns() {
        List<Double> drawn = new ArrayList<>();
        for (long runSeed = 0; runSeed < 3; runSeed++) {
            for (int generation = 0; generation < 3; generation++) {
                drawn.addAll(draws(2, runSeed, generation, 0));
                drawn.addAll(draws(2, runSeed, generation, POPULATION));
            }
        }
        assertThat(drawn).hasSize(3 * 3 * 2 * POPULATION).doesNotHaveDuplicates();
    }

    @Test
    void generator_dependsOnTheIndexAmongParentsAndChildren_notOnTheBatch() {
        assertThat(draws(2, 7, 4, 2).subList(0, 3)).isEqualTo(draws(2, 7, 4, 0).subList(2, 5));
    }

    @Test
    void seeds_areTheMixedNumbersOfRunGenerationAndPlace() {
        long golden = 0x9E3779B97F4A7C15L;
        List<Double> expected = new ArrayList<>();
        for (int place = POPULATION; place < 2 * POPULATION; place++) {
            long number = 7 * golden + (4L << 32) + place;
            // A SplittableRandom adds the golden number to its seed before it mixes.
            long seed = new SplittableRandom(number - golden).nextLong();
            expected.add(new ResumableRandom(seed).nextDouble());
        }
        assertThat(draws(2, 7, 4, POPULATION)).isEqualTo(expected);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 8})
    void results_areTheSame_forAnyNumberOfThreads(int threads) {
        assertThat(draws(threads, 1, 2, 3)).isEqualTo(draws(1, 1, 2, 3));
    }

    private List<Double> draws(int threads, long runSeed, int generation, int firstIndex) {
        try (ParallelEvaluator evaluator = new ParallelEvaluator(DrawingTask::new, threads, runSeed)) {
            List<Genotype> population = Collections.nCopies(POPULATION, genotype);
            return evaluator
                    .evaluate(population, generation, firstIndex, new ResumableRandom(1), individual -> {})
                    .stream()
                    .map(individual -> individual.evaluation().objectives()[0])
                    .toList();
        }
    }

    /** Returns the first number drawn as the score. */
    private static final class DrawingTask extends SmallTask {
        @Override
        public Evaluation evaluate(Genotype evaluated, ResumableRandom random) {
            return new Evaluation(
                    new double[] {random.nextDouble()}, new double[0], new int[1], Evaluation.Outcomes.NONE);
        }
    }

    @Test
    void evaluatorWithoutThreads_isRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new ParallelEvaluator(DrawingTask::new, 0, 1))
                .withMessage("number of threads must be at least 1, is 0");
    }
}
