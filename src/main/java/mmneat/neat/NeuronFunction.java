package mmneat.neat;

/**
 * A function of the user's own that turns a neuron's sum into its activation, as the hyperbolic tangent does.
 *
 * <p>Implementations keep no state: one object serves all neurons, networks and threads. Parameter {@code activation}
 * names the class, which then needs a public constructor without arguments (docs/extend.md); from Java, {@link
 * ActivationFunction#own} takes an object.
 */
@FunctionalInterface
public interface NeuronFunction {

    /**
     * The activation of a neuron, a finite number.
     *
     * @param sum sum of the activations of the neuron's sources, each times the weight of its link; the value of an
     *     input neuron
     */
    double of(double sum);
}
