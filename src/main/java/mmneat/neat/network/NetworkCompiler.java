package mmneat.neat.network;

import java.util.Arrays;
import java.util.List;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.NodeGene;

/**
 * Turns one genotype into a {@link Network}; used once. Time is linear in nodes and links: everything is sorted by counting.
 *
 * <p>"Position" is an index into the genotype's nodes, "slot" an index into a state's activations.
 */
final class NetworkCompiler {

    private final Genotype genotype;
    private final int nodes;
    private final int inputs;
    private final int firstOutput;

    /** Active links into each node, by source position: those of node p are [incomingStart[p], incomingStart[p + 1]). */
    private final int[] incomingStart;

    private final int[] incomingSource;
    private final double[] incomingWeight;

    /** Per position: whether the node takes part. */
    private final boolean[] included;
    /** Per position: whether a link of the network reads the node. */
    private final boolean[] read;

    private final int[] slotOfNode;

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
        gatherIncomingLinks();
        Arrays.fill(included, 0, withAllNodes ? nodes : inputs, true);
        includeSourcesOfOutputs();
    }

    Network compile() {
        int[] levelOfNode = levels();
        int[] levelStart = numberSlots(levelOfNode);
        int firstLazy = levelStart[levelStart.length - 1];
        int[] nodeOfSlot = nodesOfSlots();
        return withLinks(nodeOfSlot, levelStart, firstLazy);
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
        NodePositions positions = new NodePositions(genotype.nodes());
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

    /** Gives out the slots: inputs, neurons by level and position, lazy outputs. Returns where the levels start. */
    private int[] numberSlots(int[] levelOfNode) {
        int[] size = new int[nodes + 2];
        int levels = 0;
        for (int i = inputs; i < nodes; i++) {
            if (included[i] && !isLazy(i)) {
                size[levelOfNode[i]]++;
                levels = Math.max(levels, levelOfNode[i]);
            }
        }
        int[] levelStart = new int[levels + 1];
        levelStart[0] = inputs;
        for (int level = 1; level <= levels; level++) {
            levelStart[level] = levelStart[level - 1] + size[level];
        }
        int[] next = levelStart.clone();
        int nextLazy = levelStart[levels];
        for (int i = 0; i < nodes; i++) {
            if (i < inputs) {
                slotOfNode[i] = i;
            } else if (!included[i]) {
                slotOfNode[i] = Network.LEFT_OUT;
            } else if (isLazy(i)) {
                slotOfNode[i] = nextLazy++;
            } else {
                slotOfNode[i] = next[levelOfNode[i] - 1]++;
            }
        }
        return levelStart;
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

    private Network withLinks(int[] nodeOfSlot, int[] levelStart, int firstLazy) {
        int slots = nodeOfSlot.length;
        int recurrentLinks = 0;
        int recurrentTargets = 0;
        int links = 0;
        for (int target : nodeOfSlot) {
            int recurrent = 0;
            for (int link = incomingStart[target]; link < incomingStart[target + 1]; link++) {
                recurrent += incomingSource[link] >= target ? 1 : 0;
                links++;
            }
            recurrentLinks += recurrent;
            recurrentTargets += recurrent > 0 ? 1 : 0;
        }
        int[] forwardStart = new int[slots + 1];
        int[] forwardSource = new int[links - recurrentLinks];
        double[] forwardWeight = new double[links - recurrentLinks];
        int[] recurrentTarget = new int[recurrentTargets];
        int[] recurrentStart = new int[recurrentTargets + 1];
        int[] recurrentSource = new int[recurrentLinks];
        double[] recurrentWeight = new double[recurrentLinks];
        int forward = 0;
        int recurrent = 0;
        int recurrentEntry = 0;
        for (int slot = 0; slot < slots; slot++) {
            int target = nodeOfSlot[slot];
            int recurrentBefore = recurrent;
            for (int link = incomingStart[target]; link < incomingStart[target + 1]; link++) {
                int source = incomingSource[link];
                if (source < target) {
                    forwardSource[forward] = slotOfNode[source];
                    forwardWeight[forward++] = incomingWeight[link];
                } else {
                    recurrentSource[recurrent] = slotOfNode[source];
                    recurrentWeight[recurrent++] = incomingWeight[link];
                }
            }
            forwardStart[slot + 1] = forward;
            if (recurrent > recurrentBefore) {
                recurrentTarget[recurrentEntry++] = slot;
                recurrentStart[recurrentEntry] = recurrent;
            }
        }
        return new Network(
                genotype,
                slotOfNode,
                firstLazy,
                levelStart,
                forwardStart,
                forwardSource,
                forwardWeight,
                recurrentTarget,
                recurrentStart,
                recurrentSource,
                recurrentWeight,
                functions(nodeOfSlot));
    }

    private ActivationFunction[] functions(int[] nodeOfSlot) {
        List<NodeGene> genes = genotype.nodes();
        boolean allTanh = true;
        ActivationFunction[] functions = new ActivationFunction[nodeOfSlot.length];
        for (int slot = 0; slot < functions.length; slot++) {
            functions[slot] = genes.get(nodeOfSlot[slot]).activation();
            allTanh &= functions[slot] == ActivationFunction.TANH;
        }
        return allTanh ? null : functions;
    }
}
