package mmneat.nsga2;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.ToIntFunction;
import mmneat.random.ResumableRandom;

/**
 * Parent selection: binary tournaments choose parents, and a {@link Variation} makes children from them.
 *
 * <p>Children are made in passes. A pass without crossover makes one child; a pass with crossover makes two. With a
 * crossover rate of 0.5, about two thirds of all children therefore come from crossover.
 *
 * <p>Source: docs/specification/evolution.md, section 2.4.
 *
 * @param isCrossing whether crossover is used at all; if not, no random number is drawn for that decision
 * @param crossoverRate probability that a pass crosses two parents, in [0, 1]
 * @param crowding the individuals among which the crowding distance is measured
 */
public record ParentSelection(boolean isCrossing, double crossoverRate, Crowding crowding) {

    /**
     * Checked settings.
     *
     * @throws IllegalArgumentException if {@code crossoverRate} is not in [0, 1]
     * @throws NullPointerException if the crowding is missing
     */
    public ParentSelection {
        Objects.requireNonNull(crowding, "crowding");
        if (!(crossoverRate >= 0 && crossoverRate <= 1)) {
            throw new IllegalArgumentException("crossoverRate must be in [0, 1], is " + crossoverRate);
        }
    }

    /**
     * Makes {@code count} children.
     *
     * @param parents the parents, at least one if children are wanted
     * @param scores {@code scores[parent][objective]}
     * @param isFirstGeneration whether this is generation 0. With {@link Crowding#WHOLE_POPULATION}, its tournaments
     *     are those of the original: only dominance counts, and the second contestant wins ties
     * @param count number of children
     * @param variation makes the children
     * @throws IllegalArgumentException if there are not as many scores as parents, no parents although children are
     *     wanted, or scores that cannot be compared ({@link NondominatedSorting#of})
     * @throws IllegalStateException if {@link Variation#fromTwo} returns no child, or more children than are still to
     *     be made (its argument {@code room})
     */
    public <P, C> List<C> children(
            List<P> parents,
            double[][] scores,
            boolean isFirstGeneration,
            int count,
            Variation<P, C> variation,
            ResumableRandom random) {
        requireParents(parents.size(), scores.length, count);
        return children(parents, tournament(scores, isFirstGeneration)::winner, count, variation, random);
    }

    /**
     * Makes {@code count} children of parents that are chosen in another way.
     *
     * @param choice gives the index of a parent, once for each parent that is needed
     * @throws IllegalStateException if {@link Variation#fromTwo} returns no child, or more children than are still to
     *     be made, or {@code choice} returns an index without a parent
     */
    public <P, C> List<C> children(
            List<P> parents,
            ToIntFunction<ResumableRandom> choice,
            int count,
            Variation<P, C> variation,
            ResumableRandom random) {
        List<C> children = new ArrayList<>(count);
        while (children.size() < count) {
            P parent = chosen(parents, choice, random);
            if (isCrossing && random.nextDouble() < crossoverRate) {
                P mate = chosen(parents, choice, random);
                int room = count - children.size();
                List<C> pair = variation.fromTwo(parent, mate, room, random);
                requireFitting(pair.size(), room);
                children.addAll(pair);
            } else {
                children.add(variation.fromOne(parent, random));
            }
        }
        return children;
    }

    private static void requireParents(int parents, int scores, int count) {
        if (parents != scores) {
            throw new IllegalArgumentException("there are " + parents + " parents but scores of " + scores);
        }
        if (count < 0) {
            throw new IllegalArgumentException("number of children must not be negative, is " + count);
        }
        if (count > 0 && parents == 0) {
            throw new IllegalArgumentException(count + " children cannot be made without parents");
        }
    }

    private static <P> P chosen(List<P> parents, ToIntFunction<ResumableRandom> choice, ResumableRandom random) {
        int index = choice.applyAsInt(random);
        if (index < 0 || index >= parents.size()) {
            throw new IllegalStateException("the selection chose parent " + index + " of " + parents.size());
        }
        return parents.get(index);
    }

    private static void requireFitting(int children, int room) {
        if (children < 1 || children > room) {
            throw new IllegalStateException(
                    "two parents must have 1 to " + room + " children, the variation gave " + children);
        }
    }

    private Tournament tournament(double[][] scores, boolean isFirstGeneration) {
        NondominatedSorting sorting = NondominatedSorting.of(scores, crowding);
        // The original's quirk: in generation 0 only dominance counts, and the second contestant wins ties.
        return isFirstGeneration && crowding == Crowding.WHOLE_POPULATION
                ? Tournament.byDominance(scores, sorting)
                : Tournament.byCrowding(scores, sorting);
    }
}
