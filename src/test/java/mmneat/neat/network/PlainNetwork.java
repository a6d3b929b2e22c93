package mmneat.neat.network;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;

/**
 * A plain reference implementation of networks: node objects push their activations along their links. Source:
 * docs/specification/networks.md, section 5.
 */
final class PlainNetwork {

    private final Genotype genotype;
    private final List<Node> nodes = new ArrayList<>();

    private static final class Node {
        private final List<Node> targets = new ArrayList<>();
        private final List<Double> weights = new ArrayList<>();
        private double sum;
        private double activation;
    }

    PlainNetwork(Genotype genotype) {
        this.genotype = genotype;
        Map<Long, Node> byInnovation = new HashMap<>();
        genotype.nodes().forEach(gene -> {
            Node node = new Node();
            nodes.add(node);
            byInnovation.put(gene.innovation(), node);
        });
        for (LinkGene link : genotype.links()) {
            if (link.active()) {
                Node source = byInnovation.get(link.source());
                source.targets.add(byInnovation.get(link.target()));
                source.weights.add(link.weight());
            }
        }
    }

    void process(double[] inputs) {
        for (int i = 0; i < inputs.length; i++) {
            nodes.get(i).sum += inputs[i];
        }
        for (int i = 0; i < nodes.size(); i++) {
            Node node = nodes.get(i);
            node.activation = activation(i, node.sum);
            node.sum = 0;
            for (int link = 0; link < node.targets.size(); link++) {
                node.targets.get(link).sum += node.activation * node.weights.get(link);
            }
        }
    }

    private double activation(int position, double x) {
        return switch (genotype.nodes().get(position).activation().code()) {
            case 0 -> 1 / (1 + StrictMath.exp(Math.max(-7, Math.min(7, -x))));
            case 1 -> StrictMath.tanh(x);
            case 2 -> x;
            case 3 -> 2 * bitLogistic(x) - 1;
            case 4 -> bitLogistic(x);
            default -> genotype.nodes().get(position).activation().ofOwn(x);
        };
    }

    private static double bitLogistic(double x) {
        long upper = (long) (1512775 * -x + 1072632447);
        return 1 / (1 + Double.longBitsToDouble(upper << 32));
    }

    void flush() {
        nodes.forEach(node -> {
            node.sum = 0;
            node.activation = 0;
        });
    }

    double activation(int position) {
        return nodes.get(position).activation;
    }

    double output(int output) {
        return activation(genotype.firstOutput() + output);
    }

    /** Modules that share the highest preference. */
    List<Integer> preferredModules() {
        int modules = genotype.modules();
        double highest = Double.NEGATIVE_INFINITY;
        for (int module = 0; module < modules; module++) {
            highest = Math.max(highest, output(genotype.layout().preferenceOutput(module)));
        }
        List<Integer> preferred = new ArrayList<>();
        for (int module = 0; module < modules; module++) {
            if (output(genotype.layout().preferenceOutput(module)) == highest) {
                preferred.add(module);
            }
        }
        return preferred;
    }
}
