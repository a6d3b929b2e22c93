package mmneat.analysis.replay;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import mmneat.analysis.replay.ReplayNetwork.Kind;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.io.NetworkLabels;

/**
 * Converts a genotype into the network that the page draws. The layer of a hidden node is the length of the longest
 * path to it from an input.
 */
final class NetworkPicture {

    private NetworkPicture() {}

    static ReplayNetwork of(Genotype genotype, NetworkLabels labels) {
        int inputs = genotype.inputs();
        int count = genotype.nodes().size();
        Map<Long, Integer> positions = new HashMap<>();
        for (int i = 0; i < count; i++) {
            positions.put(genotype.nodes().get(i).innovation(), i);
        }
        List<ReplayNetwork.Link> links = new ArrayList<>();
        for (LinkGene link : genotype.links()) {
            if (link.active()) {
                int source = Objects.requireNonNull(positions.get(link.source()));
                int target = Objects.requireNonNull(positions.get(link.target()));
                // Whether a link is recurrent follows from the order of the nodes, not from the gene's flag: see
                // docs/specification/networks.md, section 5.
                links.add(new ReplayNetwork.Link(source, target, link.weight(), target <= source));
            }
        }
        double[] depth = depths(count, links);
        double deepest = 0;
        for (int i = inputs; i < genotype.firstOutput(); i++) {
            deepest = Math.max(deepest, depth[i]);
        }
        List<ReplayNetwork.Node> nodes = new ArrayList<>();
        for (int i = inputs; i < count; i++) {
            int output = i - genotype.firstOutput();
            if (output < 0) {
                nodes.add(new ReplayNetwork.Node(Kind.HIDDEN, -1, Math.max(1, depth[i]) / (Math.max(1, deepest) + 1)));
            } else {
                Kind kind = genotype.layout().hasPreferenceNeurons()
                                && genotype.layout().isPreference(output)
                        ? Kind.PREFERENCE
                        : Kind.POLICY;
                nodes.add(new ReplayNetwork.Node(kind, genotype.layout().moduleOf(output), 1));
            }
        }
        return new ReplayNetwork(labels.inputs(), nodes, links, labels.modules());
    }

    /** Length of the longest path of forward links from an input to each node; nodes are in activation order. */
    private static double[] depths(int count, List<ReplayNetwork.Link> links) {
        double[] depth = new double[count];
        for (int node = 0; node < count; node++) {
            for (ReplayNetwork.Link link : links) {
                if (link.target() == node && !link.recurrent()) {
                    depth[node] = Math.max(depth[node], depth[link.source()] + 1);
                }
            }
        }
        return depth;
    }
}
