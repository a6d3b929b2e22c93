package mmneat.neat;

import java.util.Objects;

/**
 * One neuron of a genotype.
 *
 * @param innovation innovation number. Inputs and outputs are numbered by position: input i has -i - 1, output o of a
 *     network with n inputs has -n - o - 1 (with the exception at {@link GenotypeDraft#nextOutputInnovation}). Hidden
 *     neurons have numbers from 0 on, from the counter that they share with new links
 * @param type input, hidden or output
 * @param activation the neuron's activation function
 * @param frozen whether new links into this neuron are forbidden
 * @param fromCombiningCrossover marks a shadow entry of the archetype; false in every network
 */
public record NodeGene(
        long innovation, NodeType type, ActivationFunction activation, boolean frozen, boolean fromCombiningCrossover) {

    /**
     * A checked gene.
     *
     * @throws NullPointerException if the type or the function is missing
     */
    public NodeGene {
        Objects.requireNonNull(type, "type");
        Objects.requireNonNull(activation, "activation");
    }

    /** A neuron that is neither frozen nor a shadow. */
    public NodeGene(long innovation, NodeType type, ActivationFunction activation) {
        this(innovation, type, activation, false, false);
    }

    /** This gene with another activation function. */
    public NodeGene withActivation(ActivationFunction function) {
        return function == activation ? this : new NodeGene(innovation, type, function, frozen, fromCombiningCrossover);
    }

    /** This gene, frozen or not. */
    public NodeGene withFrozen(boolean value) {
        return value == frozen ? this : new NodeGene(innovation, type, activation, value, fromCombiningCrossover);
    }
}
