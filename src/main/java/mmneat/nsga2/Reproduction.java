package mmneat.nsga2;

import java.util.ArrayList;
import java.util.List;
import mmneat.random.ResumableRandom;

/**
 * Makes children from scored parents.
 *
 * <p>Children are made in passes. A pass without crossover makes one child, a pass with crossover makes two, so with a crossover
 * rate of 0.5 about two thirds of all children come from crossover.
 *
 * <p>Source: spec/evolution.md, section 2.4.
 *
 * @param mating whether there is crossover at all; without it nothing is drawn for that decision
 * @param crossoverRate probability that a pass crosses two parents, in [0, 1]
 * @param crowding among whom the crowding distance is measured
 */
public record Reproduction(boolean mating, double crossoverRate, Crowding crowding) {

    public Reproduction {
        if (!(crossoverRate >= 0 && crossoverRate <= 1)) {
            throw new IllegalArgumentException("crossoverRate must be in [0, 1], is " + crossoverRate);
        }
    }

    /**
     * Makes {@code count} children, every one of them mutated.
     *
     * @param parents the parents, at least one if children are wanted
     * @param scores {@code scores[parent][objective]}
     * @param firstGeneration whether this is generation 0, whose tournaments differ
     */
    public <G> List<Child<G>> children(
            List<G> parents,
            double[][] scores,
            boolean firstGeneration,
            int count,
            Breeding<G> breeding,
            ResumableRandom random) {
        NondominatedSorting sorting = NondominatedSorting.of(scores, crowding);
        Tournament tournament = tournament(scores, sorting, firstGeneration);
        List<Child<G>> children = new ArrayList<>(count);
        while (children.size() < count) {
            int parent = tournament.winner(random);
            G base = breeding.copy(parents.get(parent));
            int mate = Child.NO_MATE;
            if (mating && random.nextDouble() < crossoverRate) {
                mate = tournament.winner(random);
                Breeding.Crossed<G> crossed = breeding.cross(base, breeding.copy(parents.get(mate)), random);
                base = crossed.ofBase();
                // The mate's child comes first; if there is room for one only, it is dropped unmutated.
                if (children.size() + 1 < count) {
                    G mutated = breeding.mutate(crossed.ofMate(), random);
                    children.add(new Child<>(mutated, parent, mate, true));
                }
            }
            children.add(new Child<>(breeding.mutate(base, random), parent, mate, false));
        }
        return children;
    }

    private Tournament tournament(double[][] scores, NondominatedSorting sorting, boolean firstGeneration) {
        // The original's quirk: in generation 0 only dominance counts, and the second contestant wins ties.
        return firstGeneration && crowding == Crowding.WHOLE_POPULATION
                ? Tournament.byDominance(scores, sorting)
                : Tournament.byCrowding(scores, sorting);
    }
}
