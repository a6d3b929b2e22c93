package mmneat.neat.network;

import java.util.Arrays;
import java.util.List;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodePositions;
import org.jspecify.annotations.Nullable;

/**
 * Turns one genotype into a {@link Network}; used once. Time is linear in nodes and links: everything is sorted by
 * counting.
 *
 * <p>"Position" is an index into the genotype's nodes, "slot" an index into a state's activations.
 */
final class NetworkCompiler {

    /** Not in any group yet. */
    private static final int NO_GROUP = -1;

    private static final double UNIT_ROUNDING = 0x1p-53;

    /** Passes after which a bound of differences that still grows is given up. */
    private static final int MOST_PASSES = 50;

    private final Genotype genotype;
    private final int nodes;
    private final int inputs;
    private final int firstOutput;

    /**
     * Active links into each node, by source position: those of node p are [incomingStart[p], incomingStart[p + 1]).
     */
    private final int[] incomingStart;

    private final int[] incomingSource;
    private final double[] incomingWeight;

    /** Per position: whether the node takes part. */
    private final boolean[] included;
    /** Per position: whether a link of the network reads the node. */
    private final boolean[] read;

    private final int[] slotOfNode;

    /** Per position: the group of the node, as {@link Network} explains it. */
    private final int[] group;

    /** Whether neurons that later steps need may be computed roughly, too. */
    private final boolean isRoughThroughout;

    /** How far sums may be from what they are if neurons are computed roughly; 0 if none may be. */
    private final double margin;

    NetworkCompiler(Genotype genotype, boolean withAllNodes) {
        this.genotype = genotype;
        nodes = genotype.nodes().size();
        inputs = genotype.inputs();
        firstOutput = genotype.firstOutput();
        incomingStart = new int[nodes + 1];
        int active = countActiveLinks();
        incomingSource = new int[active];
        incomingWeight = new double[active];
        included = new boolean[nodes];
        read = new boolean[nodes];
        slotOfNode = new int[nodes];
        group = new int[nodes];
        gatherIncomingLinks();
        Arrays.fill(included, 0, withAllNodes ? nodes : inputs, true);
        includeSourcesOfOutputs();
        if (!withAllNodes && allTanh()) {
            findGroups();
            double ofAll = largestDifference(0);
            isRoughThroughout = ofAll <= Network.LARGEST_MARGIN;
            double largestDifference = isRoughThroughout ? ofAll : largestDifference(Network.SHARED);
            if (largestDifference > Network.LARGEST_MARGIN) {
                Arrays.fill(group, Network.ALWAYS);
            }
            margin = largestDifference > Network.LARGEST_MARGIN ? 0 : largestDifference;
        } else {
            isRoughThroughout = false;
            margin = 0;
        }
    }

    Network compile() {
        int[] groupStart = numberSlots(levels());
        return withLinks(nodesOfSlots(), groupStart);
    }

    private boolean allTanh() {
        for (NodeGene node : genotype.nodes()) {
            if (node.activation() != ActivationFunction.TANH) {
                return false;
            }
        }
        return true;
    }

    /** Follows forward links backwards from what is needed for a known purpose. */
    private void findGroups() {
        Arrays.fill(group, NO_GROUP);
        ModuleLayout layout = genotype.layout();
        for (int output = 0; output < layout.outputs(); output++) {
            group[firstOutput + output] =
                    layout.isPreference(output) ? Network.SHARED : Network.FIRST_MODULE + layout.moduleOf(output);
        }
        for (int target = nodes - 1; target >= inputs; target--) {
            for (int link = incomingStart[target]; included[target] && link < incomingStart[target + 1]; link++) {
                if (incomingSource[link] >= target) {
                    group[incomingSource[link]] = Network.ALWAYS;
                }
            }
        }
        for (int target = nodes - 1; target >= inputs; target--) {
            for (int link = incomingStart[target]; included[target] && link < incomingStart[target + 1]; link++) {
                int source = incomingSource[link];
                if (source < target) {
                    group[source] = common(group[source], group[target]);
                }
            }
        }
    }

    private static int common(int group, int other) {
        if (group == other || group == NO_GROUP) {
            return other;
        }
        return group == Network.ALWAYS || other == Network.ALWAYS ? Network.ALWAYS : Network.SHARED;
    }

    /**
     * How far a sum can at most be from the exact one, in any step, if neurons are computed roughly; infinite if no
     * useful bound is found.
     *
     * <p>A sum's difference is what the differences of its addends make, times their weights, and the rounding of both
     * sums; the tangent does not enlarge it, but has its own error. One pass gives the differences of a step from those
     * of the step before. It is linear but for a constant c, the differences after the first pass. So twice some
     * differences hold in all steps if the next pass adds at most c/2 to each of them.
     *
     * @param first the first group that is computed roughly
     */
    private double largestDifference(int first) {
        double[] difference = new double[nodes];
        double[] constant = new double[nodes];
        for (int pass = 0; pass < MOST_PASSES; pass++) {
            boolean isBound = pass > 0;
            double largest = 0;
            for (int target = inputs; target < nodes; target++) {
                if (included[target] && group[target] >= first) {
                    double next = differenceOfSum(target, first, difference);
                    constant[target] = pass == 0 ? next : constant[target];
                    isBound &= next - difference[target] <= constant[target] / 2;
                    difference[target] = next;
                    largest = Math.max(largest, 2 * next);
                }
            }
            if (isBound || largest > Network.LARGEST_MARGIN) {
                return largest;
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    private double differenceOfSum(int target, int firstRough, double[] difference) {
        double weights = 0;
        double sum = 0;
        for (int link = incomingStart[target]; link < incomingStart[target + 1]; link++) {
            int source = incomingSource[link];
            double weight = Math.abs(incomingWeight[link]);
            weights += weight;
            if (source >= inputs && group[source] >= firstRough) {
                sum += weight * (difference[source] + RoughTanh.LARGEST_ERROR);
            }
        }
        int addends = incomingStart[target + 1] - incomingStart[target] + 1;
        return sum + 4 * addends * UNIT_ROUNDING * weights;
    }

    private int countActiveLinks() {
        int active = 0;
        for (LinkGene link : genotype.links()) {
            active += link.active() ? 1 : 0;
        }
        return active;
    }

    /** Two stable counting sorts, by source and then by target, leave the links of a target in source order. */
    private void gatherIncomingLinks() {
        List<LinkGene> links = genotype.links();
        NodePositions positions = genotype.positions();
        int active = incomingSource.length;
        int[] source = new int[active];
        int[] target = new int[active];
        double[] weight = new double[active];
        int[] next = new int[nodes + 1];
        int count = 0;
        for (int i = 0; i < links.size(); i++) {
            LinkGene link = links.get(i);
            if (link.active()) {
                source[count] = positions.of(link.source());
                target[count] = positions.of(link.target());
                weight[count] = link.weight();
                next[source[count] + 1]++;
                incomingStart[target[count] + 1]++;
                count++;
            }
        }
        for (int i = 0; i < nodes; i++) {
            next[i + 1] += next[i];
            incomingStart[i + 1] += incomingStart[i];
        }
        int[] bySource = new int[active];
        for (int i = 0; i < active; i++) {
            bySource[next[source[i]]++] = i;
        }
        System.arraycopy(incomingStart, 0, next, 0, nodes);
        for (int i : bySource) {
            int place = next[target[i]]++;
            incomingSource[place] = source[i];
            incomingWeight[place] = weight[i];
        }
    }

    /** Follows links backwards from the nodes that are wanted in any case. */
    private void includeSourcesOfOutputs() {
        int[] pending = new int[nodes];
        int count = 0;
        Arrays.fill(included, firstOutput, nodes, true);
        for (int i = inputs; i < nodes; i++) {
            if (included[i]) {
                pending[count++] = i;
            }
        }
        while (count > 0) {
            int target = pending[--count];
            for (int link = incomingStart[target]; link < incomingStart[target + 1]; link++) {
                int source = incomingSource[link];
                read[source] = true;
                if (!included[source]) {
                    included[source] = true;
                    pending[count++] = source;
                }
            }
        }
    }

    private boolean isLazy(int position) {
        return position >= firstOutput && !read[position];
    }

    /** Per position: 0 for inputs, otherwise one more than the highest level of a forward source. */
    private int[] levels() {
        int[] level = new int[nodes];
        for (int target = inputs; target < nodes; target++) {
            int highest = 0;
            for (int link = incomingStart[target]; link < incomingStart[target + 1]; link++) {
                int source = incomingSource[link];
                if (source >= target) {
                    break;
                }
                highest = Math.max(highest, level[source]);
            }
            level[target] = highest + 1;
        }
        return level;
    }

    /**
     * Gives out the slots: inputs; neurons by group, level and position; lazy outputs.
     *
     * @return the first slot of each group, and that of the lazy outputs
     */
    private int[] numberSlots(int[] levelOfNode) {
        int levels = 1 + Arrays.stream(levelOfNode).max().orElse(0);
        int groups = Network.FIRST_MODULE + genotype.layout().modules();
        int[] next = new int[groups * levels + 1];
        for (int i = inputs; i < nodes; i++) {
            if (included[i] && !isLazy(i)) {
                next[group[i] * levels + levelOfNode[i] + 1]++;
            }
        }
        next[0] = inputs;
        for (int i = 0; i < groups * levels; i++) {
            next[i + 1] += next[i];
        }
        int[] groupStart = new int[groups + 1];
        for (int i = 0; i <= groups; i++) {
            groupStart[i] = next[i * levels];
        }
        int nextLazy = groupStart[groups];
        for (int i = 0; i < nodes; i++) {
            if (i < inputs) {
                slotOfNode[i] = i;
            } else if (!included[i]) {
                slotOfNode[i] = Network.LEFT_OUT;
            } else if (isLazy(i)) {
                slotOfNode[i] = nextLazy++;
            } else {
                slotOfNode[i] = next[group[i] * levels + levelOfNode[i]]++;
            }
        }
        return groupStart;
    }

    private int[] nodesOfSlots() {
        int slots = 0;
        for (boolean takesPart : included) {
            slots += takesPart ? 1 : 0;
        }
        int[] nodeOfSlot = new int[slots];
        for (int i = 0; i < nodes; i++) {
            if (slotOfNode[i] != Network.LEFT_OUT) {
                nodeOfSlot[slotOfNode[i]] = i;
            }
        }
        return nodeOfSlot;
    }

    private Network withLinks(int[] nodeOfSlot, int[] groupStart) {
        int slots = nodeOfSlot.length;
        int links = 0;
        for (int target : nodeOfSlot) {
            links += incomingStart[target + 1] - incomingStart[target];
        }
        int[] linkStart = new int[slots + 1];
        int[] linkSource = new int[links];
        double[] linkWeight = new double[links];
        boolean hasRecurrentLinks = false;
        int next = 0;
        for (int slot = 0; slot < slots; slot++) {
            int target = nodeOfSlot[slot];
            int firstRecurrent = firstRecurrentLink(target);
            for (int link = firstRecurrent; link < incomingStart[target + 1]; link++) {
                linkSource[next] = slots + slotOfNode[incomingSource[link]] - inputs;
                linkWeight[next++] = incomingWeight[link];
                hasRecurrentLinks = true;
            }
            for (int link = incomingStart[target]; link < firstRecurrent; link++) {
                linkSource[next] = slotOfNode[incomingSource[link]];
                linkWeight[next++] = incomingWeight[link];
            }
            linkStart[slot + 1] = next;
        }
        return new Network(
                genotype,
                slotOfNode,
                groupStart,
                Arrays.copyOfRange(group, firstOutput, nodes),
                isRoughThroughout && hasRecurrentLinks,
                margin,
                hasRecurrentLinks ? groupStart[Network.ALWAYS + 1] - inputs : 0,
                linkStart,
                linkSource,
                linkWeight,
                functions(nodeOfSlot));
    }

    /** The first of a node's incoming links that comes from itself or a later node; they are the last ones. */
    private int firstRecurrentLink(int target) {
        int link = incomingStart[target];
        while (link < incomingStart[target + 1] && incomingSource[link] < target) {
            link++;
        }
        return link;
    }

    private ActivationFunction @Nullable [] functions(int[] nodeOfSlot) {
        List<NodeGene> genes = genotype.nodes();
        boolean allTanh = true;
        ActivationFunction[] functions = new ActivationFunction[nodeOfSlot.length];
        for (int slot = 0; slot < functions.length; slot++) {
            functions[slot] = genes.get(nodeOfSlot[slot]).activation();
            functions[slot].requireBound();
            allTanh &= functions[slot] == ActivationFunction.TANH;
        }
        return allTanh ? null : functions;
    }
}
