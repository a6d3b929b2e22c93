package mmneat.evolution;

import java.util.Objects;
import mmneat.neat.Genotype;

/**
 * A genotype with its evaluation.
 *
 * @param genotype the genotype, with the module usage of this evaluation
 * @param evaluation its scores
 * @param nanoseconds how long the evaluation took; evolution does not use it
 */
public record Individual(Genotype genotype, Evaluation evaluation, long nanoseconds) {

    /**
     * An individual with both its parts.
     *
     * @throws NullPointerException if a part is missing; the message names it
     */
    public Individual {
        Objects.requireNonNull(genotype, "genotype");
        Objects.requireNonNull(evaluation, "evaluation");
    }

    /** Combines a genotype and its evaluation. */
    static Individual of(Genotype genotype, Evaluation evaluation, long nanoseconds) {
        return new Individual(genotype.withModuleUsage(evaluation.moduleUsage()), evaluation, nanoseconds);
    }
}
