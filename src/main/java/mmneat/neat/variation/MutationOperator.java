package mmneat.neat.variation;

import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.random.ResumableRandom;

/**
 * One way of changing an offspring: a mutation operator. An operator of one's own is added with {@link
 * VariationSettings#withMutation}.
 *
 * <p>New genes take their innovation numbers from the pool. An operator keeps no state, and every random decision comes from the
 * generator that is passed in: then a run can be repeated.
 */
public interface MutationOperator {

    /** The operator's name in the log of mutations and in {@link Offspring#mutations}. */
    String logName();

    /**
     * Changes an offspring.
     *
     * @param offspring the genotype in the making; afterwards its genes are consistent again
     * @param pool source of innovation numbers, and the archetype, which must learn of every new neuron
     * @return whether the mutation was performed; false if the offspring offers nothing that it could change
     */
    boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random);
}
