package mmneat.neat.io;

import java.util.Locale;
import mmneat.neat.Genotype;

/** Writes a network as a DOT graph, for Graphviz. */
public final class NetworkDot {

    private NetworkDot() {}

    /**
     * The DOT text of a network.
     *
     * @param labels names of its inputs and modules
     * @throws IllegalArgumentException if the number of labels is not that of the network's inputs or modules
     */
    public static String of(Genotype genotype, NetworkLabels labels) {
        NetworkGraph graph = NetworkGraph.of(genotype, labels);
        StringBuilder dot = new StringBuilder("digraph network {\n");
        dot.append("  rankdir=BT;\n  label=").append(quoted(graph.title())).append(";\n  node [shape=circle];\n");
        int module = -1;
        for (int i = 0; i < graph.neurons().size(); i++) {
            NetworkGraph.Neuron neuron = graph.neurons().get(i);
            if (neuron.module() != module) {
                dot.append(module < 0 ? "" : "  }\n");
                module = neuron.module();
                dot.append("  subgraph cluster_module").append(module).append(" {\n");
                dot.append("    label=")
                        .append(quoted(graph.modules().get(module)))
                        .append(";\n");
            }
            dot.append(module < 0 ? "  " : "    ").append('n').append(i);
            dot.append(" [label=")
                    .append(quoted(neuron.label()))
                    .append(styleOf(neuron))
                    .append("];\n");
        }
        dot.append("  }\n");
        for (NetworkGraph.Link link : graph.links()) {
            dot.append("  n").append(link.source()).append(" -> n").append(link.target());
            dot.append(" [tooltip=\"").append(link.weight());
            dot.append("\", color=").append(link.weight() < 0 ? "red" : "blue");
            dot.append(String.format(Locale.ROOT, ", penwidth=%.2f", NetworkGraph.widthOf(link.weight())));
            dot.append(link.isRecurrent() ? ", style=dashed, constraint=false];\n" : "];\n");
        }
        return dot.append("}\n").toString();
    }

    private static String styleOf(NetworkGraph.Neuron neuron) {
        return switch (neuron.role()) {
            case INPUT -> ", shape=box";
            case PREFERENCE -> ", style=filled, fillcolor=gray";
            case HIDDEN, POLICY -> "";
        };
    }

    private static String quoted(String text) {
        return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }
}
