package mmneat.evolution;

import java.util.List;
import java.util.function.ToDoubleFunction;
import mmneat.neat.Offspring;

/**
 * What happened in one generation.
 *
 * @param number from 0
 * @param parents in population order
 * @param offspring the children and their origins, in order, before their evaluation; empty when the final parents were
 *     evaluated
 * @param children the children after their evaluation, in the order of {@code offspring}
 * @param archetypeSize entries of the archetype when the children had been made
 */
public record Generation(
        int number, List<Individual> parents, List<Offspring> offspring, List<Individual> children, int archetypeSize) {

    public Generation {
        parents = List.copyOf(parents);
        offspring = List.copyOf(offspring);
        children = List.copyOf(children);
    }

    /** The parent with the largest {@link Task#championRank}; of several equally good the last, as in the original. */
    public Individual champion(Task task) {
        return best(parents, parent -> task.championRank(parent.evaluation()));
    }

    /** The best of a population in an objective; of several equally good the last, as in the original. */
    public static Individual bestIn(List<Individual> population, int objective) {
        return best(population, individual -> individual.evaluation().objectives()[objective]);
    }

    private static Individual best(List<Individual> population, ToDoubleFunction<Individual> score) {
        return population.stream()
                .reduce((best, next) -> score.applyAsDouble(next) >= score.applyAsDouble(best) ? next : best)
                .orElseThrow();
    }
}
