package mmneat.neat.variation;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import mmneat.random.ResumableRandom;

/**
 * Factory of the networks that evolution starts from. They have no hidden neurons. Each policy neuron is linked to all
 * inputs, or to randomly drawn ones if {@link InputSelection} says so. Each preference neuron is linked to one input,
 * drawn at random for each network.
 *
 * <p>Source: docs/specification/networks.md, sections 3.2 and 3.3.
 *
 * @param inputs number of inputs
 * @param layout outputs and modules
 * @param selection the inputs that a policy neuron is linked to
 * @param activation activation function of all neurons, inputs included
 */
public record InitialNetworks(
        int inputs, ModuleLayout layout, InputSelection selection, ActivationFunction activation) {

    /**
     * Checked settings.
     *
     * @throws IllegalArgumentException if there is no input, or a policy neuron is to be linked to more inputs than
     *     there are
     * @throws NullPointerException if a part is missing; the message names it
     */
    public InitialNetworks {
        if (inputs < 1) {
            throw new IllegalArgumentException("inputs must be at least 1, is " + inputs);
        }
        Objects.requireNonNull(layout, "layout");
        Objects.requireNonNull(selection, "selection");
        Objects.requireNonNull(activation, "activation");
        if (selection.linksInto(inputs) > inputs) {
            throw new IllegalArgumentException(
                    "a policy neuron cannot be linked to " + selection.linksPerOutput() + " of " + inputs + " inputs");
        }
    }

    /** Networks as in the published experiments: every input linked to every policy neuron, tanh everywhere. */
    public InitialNetworks(int inputs, ModuleLayout layout) {
        this(inputs, layout, InputSelection.ALL, ActivationFunction.TANH);
    }

    /** Creates a random network with the given id and no module usage. */
    public Genotype create(long id, ResumableRandom random) {
        int outputs = layout.outputs();
        List<NodeGene> nodes = new ArrayList<>(inputs + outputs);
        for (int i = 0; i < inputs; i++) {
            nodes.add(new NodeGene(-i - 1L, NodeType.INPUT, activation));
        }
        for (int output = 0; output < outputs; output++) {
            nodes.add(new NodeGene(GenotypeDraft.outputInnovation(inputs, output), NodeType.OUTPUT, activation));
        }
        List<LinkGene> links = new ArrayList<>();
        for (int output = 0; output < outputs; output++) {
            for (int input : sourcesOf(output, random)) {
                links.add(new LinkGene(
                        -(inputs + outputs) - 2L - (long) output * inputs - input,
                        nodes.get(input).innovation(),
                        nodes.get(inputs + output).innovation(),
                        Draws.smallWeight(random),
                        false));
            }
        }
        return new Genotype(
                id, inputs, layout, nodes, GenotypeDraft.activeLinksBySource(nodes, links), new int[layout.modules()]);
    }

    /**
     * Creates a population of random networks with the next ids of the pool. The pool must have been made from one of
     * these networks.
     *
     * @throws IllegalArgumentException if {@code size} is negative
     */
    public List<Genotype> createPopulation(int size, GenePool pool, ResumableRandom random) {
        if (size < 0) {
            throw new IllegalArgumentException("size of the population must not be negative, is " + size);
        }
        List<Genotype> population = new ArrayList<>(size);
        for (int i = 0; i < size; i++) {
            population.add(create(pool.takeGenotypeId(), random));
        }
        return population;
    }

    /**
     * Returns the inputs linked to an output, in the order in which their weights are drawn. Randomly selected inputs
     * keep the order of their shuffle. Source: docs/specification/original-options.md, section 2.1.
     */
    private int[] sourcesOf(int output, ResumableRandom random) {
        if (layout.isPreference(output)) {
            return Draws.distinct(1, inputs, random);
        }
        if (selection.isSelective()) {
            return Draws.distinct(selection.linksInto(inputs), inputs, random);
        }
        int[] sources = new int[inputs];
        for (int i = 0; i < inputs; i++) {
            sources[i] = i;
        }
        return sources;
    }
}
