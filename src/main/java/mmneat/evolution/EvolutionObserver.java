package mmneat.evolution;

/**
 * Is told how an evolution goes: for logs, progress and checkpoints. Called by the evolving thread; what it throws ends the
 * evolution.
 */
public interface EvolutionObserver {

    /**
     * An individual has been evaluated.
     *
     * @param generation number of the generation
     * @param done how many of this generation have been, this one included
     * @param total how many of this generation will be: parents and children; the parents alone at the very end
     */
    default void evaluated(int generation, int done, int total, Individual individual) {}

    /**
     * A generation is over.
     *
     * @param generation what happened
     * @param next the state from which the next generation starts: what a checkpoint holds
     */
    default void generationCompleted(Generation generation, EvolutionState next) {}

    /** The final parents have been evaluated, and evolution is over. */
    default void completed(Generation finalParents) {}
}
