package mmneat.nsga2;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import mmneat.random.ResumableRandom;

/**
 * The complete NSGA-II algorithm for individuals of any type whose scores do not change: as many children as parents in
 * each generation, binary tournaments, crowding within fronts.
 *
 * <p>{@code mmneat.evolution} evolves networks with noisy scores; it evaluates parents again in every generation.
 *
 * <p>Source: Deb, Pratap, Agarwal and Meyarivan 2002, section III.
 */
public final class Nsga2 {

    private record Scored<P>(P individual, double[] scores) {}

    private Nsga2() {}

    /**
     * Evolves a population.
     *
     * @param population the first parents, at least one
     * @param scores the scores of an individual, all maximised and finite
     * @param variation makes children: {@link Variation#fromTwo} with probability 0.5, which makes about two thirds of
     *     all children, else {@link Variation#fromOne}. A variation without crossover keeps the default {@code fromTwo}
     * @param generations number of generations in which children are made
     * @return the last parents, as many as the first
     * @throws IllegalArgumentException if there are no parents or the scores cannot be compared
     */
    public static <P> List<P> evolve(
            List<P> population,
            Function<P, double[]> scores,
            Variation<P, P> variation,
            int generations,
            ResumableRandom random) {
        if (population.isEmpty()) {
            throw new IllegalArgumentException("population must not be empty");
        }
        ParentSelection selection = new ParentSelection(true, 0.5, Crowding.PER_FRONT);
        List<Scored<P>> parents = scored(population, scores);
        for (int generation = 0; generation < generations; generation++) {
            List<P> children = selection.children(
                    individuals(parents), table(parents), generation == 0, population.size(), variation, random);
            List<Scored<P>> all = new ArrayList<>(parents);
            all.addAll(scored(children, scores));
            int[] survivors = SurvivorSelection.survivors(table(all), population.size(), Crowding.PER_FRONT);
            parents = Arrays.stream(survivors).mapToObj(all::get).toList();
        }
        return individuals(parents);
    }

    private static <P> List<Scored<P>> scored(List<P> individuals, Function<P, double[]> scores) {
        return individuals.stream()
                .map(individual -> new Scored<>(individual, scores.apply(individual)))
                .toList();
    }

    private static <P> List<P> individuals(List<Scored<P>> scored) {
        return scored.stream().map(Scored::individual).toList();
    }

    private static double[][] table(List<? extends Scored<?>> scored) {
        return scored.stream().map(Scored::scores).toArray(double[][]::new);
    }
}
