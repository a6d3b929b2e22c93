package mmneat.neat.io;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.IntStream;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;

/**
 * The neurons and active links of a genotype that a drawing or a graph file shows.
 *
 * @param title one line that identifies the network
 * @param neurons neurons in activation order
 * @param links active links in the genotype's order
 * @param modules name of each output module
 */
record NetworkGraph(String title, List<Neuron> neurons, List<Link> links, List<String> modules) {

    /** The role of a neuron. */
    enum Role {
        /** Gets a value from outside. */
        INPUT,
        /** Neither input nor output. */
        HIDDEN,
        /** Output neuron that answers for its module. */
        POLICY,
        /** Output neuron that says how much its module should be chosen. */
        PREFERENCE
    }

    /**
     * A neuron.
     *
     * @param innovation its innovation number
     * @param role its role
     * @param module the output's module; -1 for other neurons
     * @param label an input's name, or the kind of the neuron
     */
    record Neuron(long innovation, Role role, int module, String label) {}

    /**
     * A link.
     *
     * @param source position of the neuron that it comes from
     * @param target position of the neuron that it leads to
     * @param weight its weight
     */
    record Link(int source, int target, double weight) {
        /** Whether the link transmits its source's activation of the previous step. */
        boolean isRecurrent() {
            return target <= source;
        }
    }

    /**
     * The graph of a genotype.
     *
     * @throws IllegalArgumentException if the labels are for another network
     */
    static NetworkGraph of(Genotype genotype, NetworkLabels labels) {
        labels.requireFor(genotype.inputs(), genotype.modules());
        List<Neuron> neurons = new ArrayList<>();
        Map<Long, Integer> positions = new HashMap<>();
        for (int i = 0; i < genotype.nodes().size(); i++) {
            neurons.add(neuron(genotype, i, labels));
            positions.put(genotype.nodes().get(i).innovation(), i);
        }
        List<Link> links = new ArrayList<>();
        for (LinkGene gene : genotype.links()) {
            if (gene.active()) {
                links.add(new Link(
                        Objects.requireNonNull(positions.get(gene.source())),
                        Objects.requireNonNull(positions.get(gene.target())),
                        gene.weight()));
            }
        }
        String title = "Network " + genotype.id() + ": " + genotype.inputs() + " inputs, " + genotype.hidden()
                + " hidden, " + genotype.modules() + (genotype.modules() == 1 ? " module, " : " modules, ")
                + links.size() + " links";
        List<String> modules =
                IntStream.range(0, genotype.modules()).mapToObj(labels::module).toList();
        return new NetworkGraph(title, neurons, links, modules);
    }

    /** Width of a link in the drawing: it grows with the absolute weight, quickly at first, up to 4.5. */
    static double widthOf(double weight) {
        return 0.5 + 4 * (1 - Math.exp(-Math.abs(weight) / 2));
    }

    private static Neuron neuron(Genotype genotype, int position, NetworkLabels labels) {
        NodeGene gene = genotype.nodes().get(position);
        if (gene.type() == NodeType.INPUT) {
            return new Neuron(gene.innovation(), Role.INPUT, -1, labels.input(position));
        }
        if (gene.type() == NodeType.HIDDEN) {
            return new Neuron(gene.innovation(), Role.HIDDEN, -1, "hidden " + gene.innovation());
        }
        ModuleLayout layout = genotype.layout();
        int output = position - genotype.firstOutput();
        int module = layout.moduleOf(output);
        return layout.isPreference(output)
                ? new Neuron(gene.innovation(), Role.PREFERENCE, module, "preference of " + labels.module(module))
                : new Neuron(gene.innovation(), Role.POLICY, module, "policy of " + labels.module(module));
    }
}
