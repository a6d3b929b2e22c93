package mmneat.analysis.replay;

import java.util.List;
import java.util.Objects;

/**
 * The network of the player as the page draws it.
 *
 * @param inputs label of each input, in the order of the sensor values
 * @param nodes hidden and output nodes, in the order of the recorded activations
 * @param links all links
 * @param modules name of each output module
 */
public record ReplayNetwork(List<String> inputs, List<Node> nodes, List<Link> links, List<String> modules) {

    /**
     * A hidden or output node.
     *
     * @param kind its role
     * @param module module of an output node, -1 for a hidden one
     * @param layer horizontal position from 0 (just after the inputs) to 1 (the outputs)
     */
    public record Node(Kind kind, int module, double layer) {
        public Node {
            Objects.requireNonNull(kind, "kind");
        }
    }

    /** The role of a node. */
    public enum Kind {
        /** Neither input nor output. */
        HIDDEN,
        /** A policy neuron: an output that rates an action. */
        POLICY,
        /** A preference neuron: an output that says how much its module wants to decide. */
        PREFERENCE
    }

    /**
     * A link. End points count the inputs first, then {@link #nodes}.
     *
     * @param source number of the node it leaves
     * @param target number of the node it enters
     * @param weight as evolved
     * @param recurrent whether it transmits the activation of the previous step
     */
    public record Link(int source, int target, double weight, boolean recurrent) {}

    public ReplayNetwork {
        inputs = List.copyOf(inputs);
        nodes = List.copyOf(nodes);
        links = List.copyOf(links);
        modules = List.copyOf(modules);
        int count = inputs.size() + nodes.size();
        for (Link link : links) {
            if (link.source() < 0
                    || link.source() >= count
                    || link.target() < inputs.size()
                    || link.target() >= count) {
                throw new IllegalArgumentException("a link from node " + link.source() + " to node " + link.target()
                        + " does not fit a network of " + count + " nodes with " + inputs.size() + " inputs");
            }
        }
    }

    /** A game without a network: a controller written by hand. */
    public static ReplayNetwork none() {
        return new ReplayNetwork(List.of(), List.of(), List.of(), List.of("the controller"));
    }
}
