package mmneat.neat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.ToLongFunction;
import mmneat.random.ResumableRandom;

/**
 * Crosses two networks gene by gene. Each child has exactly the structure of its own parent; genes that both parents have are
 * swapped with probability 1/2. Fitness plays no part.
 *
 * <p>Source: spec/networks.md, section 9.
 *
 * @param excessRate probability that both children get all genes, also those that only one parent has
 */
record Crossover(double excessRate) {

    /** The genes of two parents that stand for the same structure; one is null if a parent lacks it. */
    private record Pair<G>(G ofA, G ofB) {}

    private record EndPoints(long source, long target) {
        static EndPoints of(LinkGene link) {
            return new EndPoints(link.source(), link.target());
        }
    }

    /**
     * Crosses two fresh copies: each becomes the child with its structure. Ids, policy neurons per module and module usage stay
     * with the structure.
     */
    void cross(GenotypeDraft a, GenotypeDraft b, Archetype archetype, ResumableRandom random) {
        boolean isExcessShared = random.nextFloat() < excessRate;
        // Only if children get both parents' neurons does it matter where the archetype places one parent's among the
        // other's.
        Map<Long, Integer> order = isExcessShared ? GenotypeDraft.positionsOf(archetype.entries()) : Map.of();
        List<NodeGene> nodesOfA = new ArrayList<>();
        List<NodeGene> nodesOfB = new ArrayList<>();
        distribute(
                align(a.nodes(), b.nodes(), NodeGene::innovation, order), isExcessShared, nodesOfA, nodesOfB, random);

        List<LinkGene> sortedA = sortedByInnovation(a.links());
        List<LinkGene> sortedB = sortedByInnovation(withInnovationsOf(a.links(), b.links()));
        List<LinkGene> linksOfA = new ArrayList<>();
        List<LinkGene> linksOfB = new ArrayList<>();
        distribute(align(sortedA, sortedB, LinkGene::innovation, Map.of()), isExcessShared, linksOfA, linksOfB, random);
        int modulesOfA = a.modules();
        a.replaceGenes(nodesOfA, linksOfA);
        if (a.modules() != modulesOfA) {
            // As in the original the first child, and only it, counts no use of the modules it gained.
            a.setModuleUsage(Arrays.copyOf(a.moduleUsage(), a.modules()));
        }
        b.replaceGenes(nodesOfB, linksOfB);
    }

    /** Deals the genes to the children: one draw for each pair that both parents have. */
    private static <G> void distribute(
            List<Pair<G>> pairs, boolean isExcessShared, List<G> toA, List<G> toB, ResumableRandom random) {
        for (Pair<G> pair : pairs) {
            boolean isShared = pair.ofA != null && pair.ofB != null;
            boolean isSwapped = isShared && random.nextBoolean();
            G forA = isSwapped ? pair.ofB : pair.ofA;
            G forB = isSwapped ? pair.ofA : pair.ofB;
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
     * Pairs the genes of both parents. What they share comes in the same order in both lists (nodes: the archetype's; links:
     * ascending), which is all that is needed to walk along the two.
     *
     * @param order places that decide which comes first of two genes that only one parent has; without places b's comes first
     */
    private static <G> List<Pair<G>> align(
            List<G> a, List<G> b, ToLongFunction<G> innovation, Map<Long, Integer> order) {
        Set<Long> inA = innovationsOf(a, innovation);
        Set<Long> inB = innovationsOf(b, innovation);
        List<Pair<G>> pairs = new ArrayList<>(a.size() + b.size());
        int i = 0;
        int j = 0;
        while (i < a.size() || j < b.size()) {
            long nextOfA = i < a.size() ? innovation.applyAsLong(a.get(i)) : 0;
            long nextOfB = j < b.size() ? innovation.applyAsLong(b.get(j)) : 0;
            boolean isOnlyInA = i < a.size() && !inB.contains(nextOfA);
            boolean isOnlyInB = j < b.size() && !inA.contains(nextOfB);
            boolean isAFirst = order.getOrDefault(nextOfA, 0) < order.getOrDefault(nextOfB, 0);
            if (isOnlyInA && (isAFirst || !isOnlyInB)) {
                pairs.add(new Pair<>(a.get(i++), null));
            } else if (isOnlyInB) {
                pairs.add(new Pair<>(null, b.get(j++)));
            } else {
                pairs.add(new Pair<>(a.get(i++), b.get(j++)));
            }
        }
        return pairs;
    }

    private static <G> Set<Long> innovationsOf(List<G> genes, ToLongFunction<G> innovation) {
        Set<Long> innovations = new HashSet<>(genes.size() * 2);
        for (G gene : genes) {
            innovations.add(innovation.applyAsLong(gene));
        }
        return innovations;
    }

    private static List<LinkGene> sortedByInnovation(List<LinkGene> links) {
        List<LinkGene> sorted = new ArrayList<>(links);
        sorted.sort(Comparator.comparingLong(LinkGene::innovation));
        return sorted;
    }

    /** The links of b, those between the same neurons as a link of a under its number: they arose independently. */
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
