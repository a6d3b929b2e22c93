package mmneat.nsga2;

import java.util.List;
import mmneat.random.ResumableRandom;

/**
 * How children are made from parents. {@link Mating} decides who and when.
 *
 * @param <P> a parent
 * @param <C> a child, with whatever the breeder wants to say of it
 */
public interface Breeding<P, C> {

    /** The child of one parent. */
    C fromOne(P parent, ResumableRandom random);

    /**
     * The children of two parents, who may be the same.
     *
     * @param room how many children are wanted, at least 1
     * @return at least one child, at most {@code room}; the original makes two if there is room
     */
    List<C> fromTwo(P parent, P mate, int room, ResumableRandom random);
}
