package mmneat.neat.variation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import mmneat.neat.Archetype;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodePositions;
import mmneat.random.ResumableRandom;

/**
 * NEAT's crossover: crosses two networks gene by gene. Genes that both parents have are swapped with probability 1/2.
 * Genes that only one parent has stay with the child of that parent, so that each child has exactly the structure of
 * one parent. Fitness plays no part.
 *
 * <p>The exception is excess crossover, which the published experiments do not use: with probability {@code excessRate}
 * both children get all genes of both parents, and then have the same structure.
 *
 * <p>In hybrids (modules in groups, {@link ModuleLayout#groups}), a module of one parent corresponds to the module of
 * the other parent with the same number. If the two are in different groups, their genes are not swapped.
 *
 * <p>Source: docs/specification/networks.md, section 9.
 *
 * @param excessRate probability of excess crossover ({@code crossExcessRate}); 0 in the published experiments
 */
record Crossover(double excessRate) implements CrossoverOperator {

    private static final Comparator<LinkGene> BY_INNOVATION = Comparator.comparingLong(LinkGene::innovation);

    /**
     * Crosses two copies of the parents: each becomes the child with its own structure. Each child keeps its id, policy
     * neurons per module and module usage.
     */
    @Override
    public void cross(GenotypeDraft a, GenotypeDraft b, Archetype archetype, ResumableRandom random) {
        Map<Long, Integer> groupsOfA = groupsOfOutputs(a);
        Map<Long, Integer> groupsOfB = groupsOfOutputs(b);
        Set<Long> foreign = differing(groupsOfA, groupsOfB);
        boolean isExcessShared = random.nextFloat() < excessRate;
        List<NodeGene> nodesOfA = new ArrayList<>(a.nodes());
        List<NodeGene> nodesOfB = new ArrayList<>(b.nodes());
        swapShared(nodesOfA, nodesOfB, foreign, random);
        if (isExcessShared) {
            shareExcess(nodesOfA, nodesOfB, archetype);
        }

        LinkGene[] sortedA = sortedByInnovation(a.links());
        LinkGene[] sortedB = withInnovationsOf(sortedA, sortedByInnovation(b.links()));
        List<LinkGene> linksOfA = new ArrayList<>();
        List<LinkGene> linksOfB = new ArrayList<>();
        distribute(sortedA, sortedB, isExcessShared, foreign, linksOfA, linksOfB, random);
        int modulesOfA = a.modules();
        a.replaceGenes(nodesOfA, linksOfA);
        if (a.modules() != modulesOfA) {
            // As in the original, only the first child gets usage counts of 0 for the modules it gained.
            a.setModuleUsage(Arrays.copyOf(a.moduleUsage(), a.modules()));
        }
        b.replaceGenes(nodesOfB, linksOfB);
        if (isExcessShared && !groupsOfA.isEmpty()) {
            a.setGroups(groups(a, groupsOfA, groupsOfB));
            b.setGroups(groups(b, groupsOfB, groupsOfA));
        }
    }

    /** The group of each output neuron of a hybrid by innovation; empty for other networks. */
    private static Map<Long, Integer> groupsOfOutputs(GenotypeDraft draft) {
        if (draft.groups().isEmpty()) {
            return Map.of();
        }
        Map<Long, Integer> groups = new HashMap<>();
        ModuleLayout layout = draft.layout();
        for (int output = 0; output < draft.outputs(); output++) {
            groups.put(draft.output(output).innovation(), layout.choiceOf(layout.moduleOf(output)));
        }
        return groups;
    }

    /** The output neurons that both have, but in different groups. */
    private static Set<Long> differing(Map<Long, Integer> groups, Map<Long, Integer> others) {
        if (groups.isEmpty()) {
            return Set.of();
        }
        Set<Long> differing = new HashSet<>();
        groups.forEach((output, group) -> {
            if (!group.equals(others.getOrDefault(output, group))) {
                differing.add(output);
            }
        });
        return differing;
    }

    /** The group of each module of a child that also has outputs of the other parent. */
    private static List<Integer> groups(GenotypeDraft child, Map<Long, Integer> own, Map<Long, Integer> others) {
        List<Integer> groups = new ArrayList<>();
        int neuronsPerModule = child.policyNeuronsPerModule() + 1;
        for (int module = 0; module < child.modules(); module++) {
            long output = child.output(module * neuronsPerModule).innovation();
            groups.add(own.containsKey(output) ? own.get(output) : others.get(output));
        }
        return groups;
    }

    /**
     * Swaps neurons that both parents have: one draw for each, in a's order. Shared neurons have the archetype's order
     * in both lists. Only after full module mutation can the orders differ; then each child keeps its own.
     */
    private static void swapShared(List<NodeGene> a, List<NodeGene> b, Set<Long> foreign, ResumableRandom random) {
        NodePositions placesInB = new NodePositions(b);
        for (int i = 0; i < a.size(); i++) {
            long innovation = a.get(i).innovation();
            int place = placesInB.of(innovation);
            if (place >= 0 && !isAmong(foreign, innovation) && random.nextBoolean()) {
                a.set(i, b.set(place, a.get(i)));
            }
        }
    }

    /** Gives each of two lists the neurons that only the other has, all in the archetype's order. */
    private static void shareExcess(List<NodeGene> a, List<NodeGene> b, Archetype archetype) {
        List<NodeGene> onlyInA = without(a, new NodePositions(b));
        List<NodeGene> onlyInB = without(b, new NodePositions(a));
        a.addAll(onlyInB);
        b.addAll(onlyInA);
        NodePositions order = new NodePositions(archetype.entries());
        Comparator<NodeGene> byOrder = Comparator.comparingInt(node -> order.of(node.innovation()));
        a.sort(byOrder);
        b.sort(byOrder);
    }

    private static List<NodeGene> without(List<NodeGene> nodes, NodePositions others) {
        return nodes.stream()
                .filter(node -> !others.contains(node.innovation()))
                .toList();
    }

    /**
     * Distributes the links of both parents, both in ascending order, to the children: one draw for each structure that
     * both have. Of two links that only one parent has, b's comes first.
     */
    private static void distribute(
            LinkGene[] a,
            LinkGene[] b,
            boolean isExcessShared,
            Set<Long> foreign,
            List<LinkGene> toA,
            List<LinkGene> toB,
            ResumableRandom random) {
        boolean[] isSharedOfA = haveEqualIn(a, b);
        boolean[] isSharedOfB = haveEqualIn(b, a);
        int i = 0;
        int j = 0;
        while (i < a.length || j < b.length) {
            if (j < b.length && !isSharedOfB[j]) {
                if (isExcessShared) {
                    toA.add(b[j]);
                }
                toB.add(b[j++]);
            } else if (i < a.length && !isSharedOfA[i]) {
                if (isExcessShared) {
                    toB.add(a[i]);
                }
                toA.add(a[i++]);
            } else {
                boolean touchesForeign = isAmong(foreign, a[i].source()) || isAmong(foreign, a[i].target());
                boolean isSwapped = !touchesForeign && random.nextBoolean();
                toA.add(isSwapped ? b[j] : a[i]);
                toB.add(isSwapped ? a[i] : b[j]);
                i++;
                j++;
            }
        }
    }

    /** Whether a neuron is among the given ones, which usually are none. */
    private static boolean isAmong(Set<Long> neurons, long innovation) {
        return !neurons.isEmpty() && neurons.contains(innovation);
    }

    /** For each link, whether a link of the others has its innovation; both in ascending order. */
    private static boolean[] haveEqualIn(LinkGene[] links, LinkGene[] others) {
        boolean[] isShared = new boolean[links.length];
        int next = 0;
        for (int i = 0; i < links.length; i++) {
            long innovation = links[i].innovation();
            while (next < others.length && others[next].innovation() < innovation) {
                next++;
            }
            isShared[i] = next < others.length && others[next].innovation() == innovation;
        }
        return isShared;
    }

    private static LinkGene[] sortedByInnovation(List<LinkGene> links) {
        LinkGene[] sorted = links.toArray(new LinkGene[0]);
        Arrays.sort(sorted, BY_INNOVATION);
        return sorted;
    }

    /**
     * Returns the links of b in ascending order. A link between the same neurons as a link of a gets its innovation,
     * because the two arose independently. Links of equal innovation are between the same neurons already.
     */
    private static LinkGene[] withInnovationsOf(LinkGene[] a, LinkGene[] b) {
        boolean[] isSharedOfA = haveEqualIn(a, b);
        boolean[] isSharedOfB = haveEqualIn(b, a);
        LinkGene[] reconciled = b.clone();
        boolean isChanged = false;
        for (int j = 0; j < b.length; j++) {
            for (int i = 0; !isSharedOfB[j] && i < a.length; i++) {
                if (!isSharedOfA[i] && a[i].source() == b[j].source() && a[i].target() == b[j].target()) {
                    reconciled[j] = b[j].withInnovation(a[i].innovation());
                    isChanged = true;
                }
            }
        }
        if (isChanged) {
            Arrays.sort(reconciled, BY_INNOVATION);
        }
        return reconciled;
    }
}
