package mmneat.neat.variation;

import mmneat.neat.Archetype;
import mmneat.neat.GenotypeDraft;
import mmneat.random.ResumableRandom;

/**
 * A way of crossing two networks. An operator of your own replaces NEAT's ({@link VariationSettings#withCrossover}).
 *
 * <p>An operator keeps no state, and every random decision comes from the generator that is passed in: then a run can
 * be repeated.
 */
@FunctionalInterface
public interface CrossoverOperator {

    /**
     * Crosses two fresh copies of the parents, each of which becomes a child; mutation follows.
     *
     * @param first copy of the first parent; afterwards its genes are consistent again
     * @param second copy of the second parent, likewise
     * @param archetype the order of all neurons of the population, to be read only
     */
    void cross(GenotypeDraft first, GenotypeDraft second, Archetype archetype, ResumableRandom random);
}
