package mmneat.nsga2;

import mmneat.random.ResumableRandom;

/**
 * How individuals are made from others. {@link Reproduction} decides who and when.
 *
 * @param <G> what is bred
 */
public interface Breeding<G> {

    /** A copy of a parent, a new individual. */
    G copy(G parent);

    /** Two children of two parents; the arguments are copies that nobody else holds. */
    Crossed<G> cross(G base, G mate, ResumableRandom random);

    /** The child after mutation. Called once for each child that is kept, in the order in which children are appended. */
    G mutate(G child, ResumableRandom random);

    /**
     * The children of a crossover.
     *
     * @param ofBase the child with the structure of the first parent
     * @param ofMate the child with the structure of the second
     */
    record Crossed<G>(G ofBase, G ofMate) {}
}
