package mmneat.neat.variation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import mmneat.neat.Archetype;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;

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

    /** The links of two parents that represent the same structure; one is null if a parent lacks it. */
    private record Pair(@Nullable LinkGene ofA, @Nullable LinkGene ofB) {

        /** Whether one of the end points, the same for both, is among some neurons. */
        boolean touches(Set<Long> neurons) {
            LinkGene link = ofA != null ? ofA : Objects.requireNonNull(ofB);
            return neurons.contains(link.source()) || neurons.contains(link.target());
        }
    }

    private record EndPoints(long source, long target) {
        static EndPoints of(LinkGene link) {
            return new EndPoints(link.source(), link.target());
        }
    }

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

        List<LinkGene> sortedA = sortedByInnovation(a.links());
        List<LinkGene> sortedB = sortedByInnovation(withInnovationsOf(a.links(), b.links()));
        List<LinkGene> linksOfA = new ArrayList<>();
        List<LinkGene> linksOfB = new ArrayList<>();
        distribute(align(sortedA, sortedB), isExcessShared, foreign, linksOfA, linksOfB, random);
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
        Map<Long, Integer> groups = new HashMap<>();
        if (!draft.groups().isEmpty()) {
            ModuleLayout layout = draft.layout();
            for (int output = 0; output < draft.outputs(); output++) {
                groups.put(draft.output(output).innovation(), layout.choiceOf(layout.moduleOf(output)));
            }
        }
        return groups;
    }

    /** The output neurons that both have, but in different groups. */
    private static Set<Long> differing(Map<Long, Integer> groups, Map<Long, Integer> others) {
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
        Map<Long, Integer> placesInB = GenotypeDraft.positionsOf(b);
        for (int i = 0; i < a.size(); i++) {
            Integer place = placesInB.get(a.get(i).innovation());
            if (place != null && !foreign.contains(a.get(i).innovation()) && random.nextBoolean()) {
                a.set(i, b.set(place, a.get(i)));
            }
        }
    }

    /** Gives each of two lists the neurons that only the other has, all in the archetype's order. */
    private static void shareExcess(List<NodeGene> a, List<NodeGene> b, Archetype archetype) {
        List<NodeGene> onlyInA = without(a, GenotypeDraft.positionsOf(b).keySet());
        List<NodeGene> onlyInB = without(b, GenotypeDraft.positionsOf(a).keySet());
        a.addAll(onlyInB);
        b.addAll(onlyInA);
        Map<Long, Integer> order = GenotypeDraft.positionsOf(archetype.entries());
        Comparator<NodeGene> byOrder = Comparator.comparing(node -> order.get(node.innovation()));
        a.sort(byOrder);
        b.sort(byOrder);
    }

    private static List<NodeGene> without(List<NodeGene> nodes, Set<Long> innovations) {
        return nodes.stream()
                .filter(node -> !innovations.contains(node.innovation()))
                .toList();
    }

    /** Distributes the links to the children: one draw for each pair that both parents have. */
    private static void distribute(
            List<Pair> pairs,
            boolean isExcessShared,
            Set<Long> foreign,
            List<LinkGene> toA,
            List<LinkGene> toB,
            ResumableRandom random) {
        for (Pair pair : pairs) {
            boolean isShared = pair.ofA != null && pair.ofB != null;
            boolean isSwapped = isShared && !pair.touches(foreign) && random.nextBoolean();
            LinkGene forA = isSwapped ? pair.ofB : pair.ofA;
            LinkGene forB = isSwapped ? pair.ofA : pair.ofB;
            if (isExcessShared && !isShared) {
                forA = pair.ofA != null ? pair.ofA : pair.ofB;
                forB = forA;
            }
            if (forA != null) {
                toA.add(forA);
            }
            if (forB != null) {
                toB.add(forB);
            }
        }
    }

    /**
     * Pairs the links of both parents, both in ascending order; of two links that only one parent has, b's comes first.
     */
    private static List<Pair> align(List<LinkGene> a, List<LinkGene> b) {
        Set<Long> inA = innovationsOf(a);
        Set<Long> inB = innovationsOf(b);
        List<Pair> pairs = new ArrayList<>(a.size() + b.size());
        int i = 0;
        int j = 0;
        while (i < a.size() || j < b.size()) {
            if (j < b.size() && !inA.contains(b.get(j).innovation())) {
                pairs.add(new Pair(null, b.get(j++)));
            } else if (i < a.size() && !inB.contains(a.get(i).innovation())) {
                pairs.add(new Pair(a.get(i++), null));
            } else {
                pairs.add(new Pair(a.get(i++), b.get(j++)));
            }
        }
        return pairs;
    }

    private static Set<Long> innovationsOf(List<LinkGene> links) {
        Set<Long> innovations = new HashSet<>(links.size() * 2);
        for (LinkGene link : links) {
            innovations.add(link.innovation());
        }
        return innovations;
    }

    private static List<LinkGene> sortedByInnovation(List<LinkGene> links) {
        List<LinkGene> sorted = new ArrayList<>(links);
        sorted.sort(Comparator.comparingLong(LinkGene::innovation));
        return sorted;
    }

    /**
     * Returns the links of b. A link between the same neurons as a link of a gets its innovation: the two arose
     * independently.
     */
    private static List<LinkGene> withInnovationsOf(List<LinkGene> a, List<LinkGene> b) {
        Map<EndPoints, Long> innovations = new HashMap<>(a.size() * 2);
        for (LinkGene link : a) {
            innovations.put(EndPoints.of(link), link.innovation());
        }
        List<LinkGene> reconciled = new ArrayList<>(b.size());
        for (LinkGene link : b) {
            reconciled.add(link.withInnovation(innovations.getOrDefault(EndPoints.of(link), link.innovation())));
        }
        return reconciled;
    }
}
