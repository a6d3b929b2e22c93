package mmneat.neat.variation;

import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.random.ResumableRandom;

/**
 * A mutation operator: it changes one offspring. Add your own operator with {@link VariationSettings#withMutation}.
 *
 * <p>New genes take their innovation numbers from the pool. An operator keeps no state and draws every random number
 * from the generator that is passed in, so that a run can be repeated.
 */
public interface MutationOperator {

    /** The operator's name in the log of mutations and in {@link Offspring#mutations}. */
    String logName();

    /**
     * Changes an offspring.
     *
     * @param offspring the genotype to change; its genes must be consistent afterwards
     * @param pool the source of innovation numbers, and the archetype, which must receive every new neuron
     * @return whether the mutation was performed; false if it was not applicable
     */
    boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random);
}
