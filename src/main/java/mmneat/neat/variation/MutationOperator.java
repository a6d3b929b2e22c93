package mmneat.neat.variation;

import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.random.ResumableRandom;

/** One way of changing an offspring. */
interface MutationOperator {

    /** The operator's name in the original's log of mutations. */
    String logName();

    /**
     * Changes an offspring.
     *
     * @return whether the mutation was performed; false if the offspring offers nothing that it could change
     */
    boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random);
}
