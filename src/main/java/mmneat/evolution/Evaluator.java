package mmneat.evolution;

import java.util.List;
import java.util.function.Consumer;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;

/**
 * An evaluator of populations: it works in the calling thread ({@link SequentialEvaluator}) or on several threads
 * ({@link ParallelEvaluator}).
 */
public interface Evaluator {

    /**
     * Evaluates genotypes.
     *
     * @param genotypes the genotypes to evaluate, in order
     * @param generation number of the generation
     * @param firstIndex place of the first genotype among parents and children of the generation: 0, or the number of
     *     parents
     * @param random the run's generator
     * @param whenDone receives each individual, in order, in the calling thread
     * @return the individuals in the order of the genotypes
     * @throws BadEvaluationException if the number of scores differs from the number of names, a score is not finite,
     *     or the module usage does not fit the genotype
     * @throws java.util.concurrent.CancellationException if the calling thread is interrupted
     */
    List<Individual> evaluate(
            List<Genotype> genotypes,
            int generation,
            int firstIndex,
            ResumableRandom random,
            Consumer<Individual> whenDone);
}
