package mmneat.evolution;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import mmneat.neat.variation.Offspring;

/**
 * The parents and children of one generation, with their scores.
 *
 * @param number from 0
 * @param parents in population order
 * @param offspring the children and their origins, in order, before their evaluation; empty when the final parents were
 *     evaluated
 * @param children the children after their evaluation, in the order of {@code offspring}
 * @param archetypeSize entries of the archetype when the children had been made
 * @param tug what TUG changed, if the run uses it and children were made
 */
public record Generation(
        int number,
        List<Individual> parents,
        List<Offspring> offspring,
        List<Individual> children,
        int archetypeSize,
        Optional<TugStep> tug) {

    /**
     * A generation with copies of the lists.
     *
     * @throws IllegalArgumentException if the number is negative, or there are not as many children as offspring
     * @throws NullPointerException if a part is missing; the message names it
     */
    public Generation {
        if (number < 0) {
            throw new IllegalArgumentException("number must not be negative, is " + number);
        }
        parents = List.copyOf(Objects.requireNonNull(parents, "parents"));
        offspring = List.copyOf(Objects.requireNonNull(offspring, "offspring"));
        children = List.copyOf(Objects.requireNonNull(children, "children"));
        Objects.requireNonNull(tug, "tug");
        if (offspring.size() != children.size()) {
            throw new IllegalArgumentException(
                    "there are " + offspring.size() + " offspring but " + children.size() + " children evaluated");
        }
    }

    /** A generation without TUG. */
    public Generation(
            int number,
            List<Individual> parents,
            List<Offspring> offspring,
            List<Individual> children,
            int archetypeSize) {
        this(number, parents, offspring, children, archetypeSize, Optional.empty());
    }

    /**
     * Returns the parent with the largest {@link Task#championRank}. Of equally good parents it returns the last, as in
     * the original.
     *
     * @throws IllegalArgumentException if there are no parents
     */
    public Individual champion(Task task) {
        return best(parents, parent -> task.championRank(parent.evaluation()));
    }

    /**
     * Returns the best individual of a population in an objective. Of equally good ones it returns the last, as in the
     * original.
     *
     * @throws IllegalArgumentException if the population is empty
     * @throws IndexOutOfBoundsException if there is no such objective
     */
    public static Individual bestIn(List<Individual> population, int objective) {
        return best(population, individual -> individual.evaluation().objectives()[objective]);
    }

    private static Individual best(List<Individual> population, ToDoubleFunction<Individual> score) {
        return population.stream()
                .reduce((best, next) -> score.applyAsDouble(next) >= score.applyAsDouble(best) ? next : best)
                .orElseThrow(
                        () -> new IllegalArgumentException("the population is empty, so it has no best individual"));
    }
}
