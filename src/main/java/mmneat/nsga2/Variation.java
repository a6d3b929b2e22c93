package mmneat.nsga2;

import java.util.List;
import mmneat.random.ResumableRandom;

/**
 * Makes children from parents, by mutation and crossover. {@link ParentSelection} chooses the parents.
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
     * @param room the largest number of children to return, at least 1
     * @return at least one child, at most {@code room}; the original makes two if there is room
     */
    default List<C> fromTwo(P parent, P mate, int room, ResumableRandom random) {
        C first = fromOne(parent, random);
        return room == 1 ? List.of(first) : List.of(first, fromOne(mate, random));
    }
}
