package mmneat.neat.network;

import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;

/**
 * Deterministic genotypes of a given size for benchmarks and tests. They grow as in evolution: from a network of inputs
 * and outputs, by splicing links and adding links between random nodes, including recurrent links.
 */
public final class SampleGenotypes {

    private static final int CHAMPION_INPUTS = 30;

    private final RandomGenerator random;
    private final int inputs;
    private final ModuleLayout layout;
    private final List<NodeGene> nodes = new ArrayList<>();
    private final List<LinkGene> links = new ArrayList<>();
    private long nextInnovation;

    private SampleGenotypes(RandomGenerator random, int inputs, ModuleLayout layout) {
        this.random = random;
        this.inputs = inputs;
        this.layout = layout;
    }

    /** A two-module network of a champion's size: 30 inputs, 4 outputs, 25 hidden neurons, 180 active links. */
    public static Genotype champion(RandomGenerator random) {
        return grown(random, CHAMPION_INPUTS, withPreference(2), 25, 180);
    }

    /**
     * A two-module network as after about thirty mutations: 30 inputs, 4 outputs, 6 hidden neurons, 75 active links.
     */
    public static Genotype young(RandomGenerator random) {
        return grown(random, CHAMPION_INPUTS, withPreference(2), 6, 75);
    }

    /** A two-module network of 30 inputs, 4 outputs, 100 hidden neurons and 500 active links. */
    public static Genotype large(RandomGenerator random) {
        return grown(random, CHAMPION_INPUTS, withPreference(2), 100, 500);
    }

    /** A layout of modules with one policy neuron and a preference neuron each. */
    public static ModuleLayout withPreference(int modules) {
        return new ModuleLayout(2 * modules, modules, 1, false);
    }

    /**
     * A network of the given size.
     *
     * @param activeLinks number of active links; fewer if no more are possible, more if the initial network has more
     */
    public static Genotype grown(RandomGenerator random, int inputs, ModuleLayout layout, int hidden, int activeLinks) {
        return new SampleGenotypes(random, inputs, layout).grow(hidden, activeLinks);
    }

    private Genotype grow(int hidden, int activeLinks) {
        for (int i = 0; i < inputs; i++) {
            nodes.add(new NodeGene(-i - 1, NodeType.INPUT, ActivationFunction.TANH));
        }
        for (int i = 0; i < layout.outputs(); i++) {
            nodes.add(new NodeGene(-inputs - i - 1, NodeType.OUTPUT, ActivationFunction.TANH));
        }
        for (int output = 0; output < layout.outputs(); output++) {
            int only = layout.isPreference(output) ? random.nextInt(inputs) : -1;
            for (int input = 0; input < inputs; input++) {
                if (only < 0 || input == only) {
                    addLink(-input - 1, -inputs - output - 1);
                }
            }
        }
        while (nodes.size() < inputs + hidden + layout.outputs()) {
            splice();
        }
        int attempts = 100 * activeLinks;
        while (links.stream().filter(LinkGene::active).count() < activeLinks && attempts-- > 0) {
            long source = nodes.get(random.nextInt(nodes.size())).innovation();
            long target = nodes.get(random.nextInt(inputs, nodes.size())).innovation();
            if (links.stream().noneMatch(link -> link.source() == source && link.target() == target)) {
                addLink(source, target);
            }
        }
        return new Genotype(0, inputs, layout, nodes, links, new int[layout.modules()]);
    }

    private void splice() {
        int index;
        do {
            index = random.nextInt(links.size());
        } while (!links.get(index).active());
        LinkGene link = links.get(index);
        links.set(index, link.withActive(false));
        long added = nextInnovation++;
        int firstOutput = nodes.size() - layout.outputs();
        int position = Math.min(firstOutput, Math.max(inputs, position(link.source()) + 1));
        nodes.add(position, new NodeGene(added, NodeType.HIDDEN, ActivationFunction.TANH));
        addLink(link.source(), added);
        addLink(added, link.target());
    }

    private void addLink(long source, long target) {
        boolean recurrent = position(target) <= position(source);
        links.add(new LinkGene(nextInnovation++, source, target, random.nextGaussian(), recurrent));
    }

    private int position(long innovation) {
        for (int i = 0; i < nodes.size(); i++) {
            if (nodes.get(i).innovation() == innovation) {
                return i;
            }
        }
        throw new IllegalArgumentException("no node " + innovation);
    }
}
