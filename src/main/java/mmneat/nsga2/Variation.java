package mmneat.nsga2;

import java.util.List;
import mmneat.random.ResumableRandom;

/**
 * An operator that makes children from parents, by mutation and crossover. {@link ParentSelection} chooses the parents
 * and calls it. Implement {@link #fromOne}, a lambda for example; override {@link #fromTwo} to add crossover.
 *
 * @param <P> a parent
 * @param <C> a child, which may carry information on how it was made
 */
@FunctionalInterface
public interface Variation<P, C> {

    /** Makes a child from one parent. */
    C fromOne(P parent, ResumableRandom random);

    /**
     * Makes children from two parents, which may be the same. The default implementation performs no crossover: it
     * calls {@link #fromOne} for each parent that there is room for.
     *
     * @param room number of children that the generation still lacks, at least 1: no more may be returned
     * @return at least one child, at most {@code room}; the original makes two if {@code room} allows it
     */
    default List<C> fromTwo(P parent, P mate, int room, ResumableRandom random) {
        C first = fromOne(parent, random);
        return room == 1 ? List.of(first) : List.of(first, fromOne(mate, random));
    }
}
