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

    /** The child of one parent. */
    C fromOne(P parent, ResumableRandom random);

    /**
     * The children of two parents, who may be the same. Without an implementation of its own there is no crossover: the children are
     * those of each parent alone.
     *
     * @param room how many children are wanted, at least 1
     * @return at least one child, at most {@code room}; the original makes two if there is room
     */
    default List<C> fromTwo(P parent, P mate, int room, ResumableRandom random) {
        C first = fromOne(parent, random);
        return room == 1 ? List.of(first) : List.of(first, fromOne(mate, random));
    }
}
