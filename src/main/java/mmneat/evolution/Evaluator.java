package mmneat.evolution;

import java.util.List;
import java.util.function.Consumer;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;

/** How a population is evaluated: {@link SequentialEvaluator} or {@link ParallelEvaluator}. */
public interface Evaluator {

    /**
     * Evaluates genotypes.
     *
     * @param genotypes whom to evaluate, in order
     * @param generation number of the generation
     * @param firstIndex place of the first genotype among parents and children of the generation: 0, or the number of parents
     * @param random the run's generator
     * @param whenDone is told of each individual, in order, by the calling thread
     * @return the individuals in the order of the genotypes
     * @throws BadEvaluationException if the task's scores are not those that it names, no finite numbers, or its module usage not
     *     that of the genotype
     * @throws java.util.concurrent.CancellationException if the calling thread is interrupted
     */
    List<Individual> evaluate(
            List<Genotype> genotypes,
            int generation,
            int firstIndex,
            ResumableRandom random,
            Consumer<Individual> whenDone);
}
