package mmneat.evolution;

/**
 * A receiver of the events of an evolution, for logs, progress and checkpoints: an individual was evaluated, a
 * generation is complete, the evolution is complete. Override the methods of the events that matter. The evolving
 * thread calls them; an exception that one throws ends the evolution.
 */
public interface EvolutionObserver {

    /**
     * Called when an individual has been evaluated.
     *
     * @param generation number of the generation
     * @param done number of individuals of this generation evaluated so far, this one included
     * @param total number of individuals of this generation: parents and children, or the parents alone after the last
     *     generation
     */
    default void evaluated(int generation, int done, int total, Individual individual) {}

    /**
     * Called when a generation is complete.
     *
     * @param generation its parents, children and their scores
     * @param next the state from which the next generation starts, for a checkpoint
     */
    default void generationCompleted(Generation generation, EvolutionState next) {}

    /** Called once at the end, after the final parents have been evaluated. */
    default void completed(Generation finalParents) {}
}
