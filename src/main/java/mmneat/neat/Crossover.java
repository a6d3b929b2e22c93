package mmneat.neat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
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
        List<NodeGene> nodesOfA = new ArrayList<>();
        List<NodeGene> nodesOfB = new ArrayList<>();
        // Only if children get both parents' neurons does it matter where the archetype places one parent's among the
        // other's.
        Map<Long, Integer> order = isExcessShared ? GenotypeDraft.positionsOf(archetype.entries()) : Map.of();
        distribute(alignNodes(a.nodes(), b.nodes(), order), isExcessShared, nodesOfA, nodesOfB, random);

        List<LinkGene> linksOfA = new ArrayList<>();
        List<LinkGene> linksOfB = new ArrayList<>();
        List<LinkGene> reconciled = withInnovationsOf(a.links(), b.links());
        distribute(alignLinks(a.links(), reconciled), isExcessShared, linksOfA, linksOfB, random);
        a.replaceGenes(nodesOfA, linksOfA);
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
     * Pairs the nodes of both parents. Both lists are parts of the archetype's order, so the nodes they share come in the same
     * order in both, which is all that is needed to walk along the two.
     *
     * @param order place in the archetype; nodes that are not in it come first
     */
    private static List<Pair<NodeGene>> alignNodes(List<NodeGene> a, List<NodeGene> b, Map<Long, Integer> order) {
        Map<Long, Integer> positionsInA = GenotypeDraft.positionsOf(a);
        Map<Long, Integer> positionsInB = GenotypeDraft.positionsOf(b);
        List<Pair<NodeGene>> pairs = new ArrayList<>(a.size() + b.size());
        int i = 0;
        int j = 0;
        while (i < a.size() || j < b.size()) {
            boolean isAOnly = i < a.size() && !positionsInB.containsKey(a.get(i).innovation());
            boolean isBOnly = j < b.size() && !positionsInA.containsKey(b.get(j).innovation());
            if (isAOnly && isBOnly) {
                isAOnly = order.getOrDefault(a.get(i).innovation(), -1)
                        <= order.getOrDefault(b.get(j).innovation(), -1);
            }
            if (isAOnly) {
                pairs.add(new Pair<>(a.get(i++), null));
            } else if (isBOnly) {
                pairs.add(new Pair<>(null, b.get(j++)));
            } else {
                pairs.add(new Pair<>(a.get(i++), b.get(j++)));
            }
        }
        return pairs;
    }

    /** Pairs the links of both parents by innovation, ascending. */
    private static List<Pair<LinkGene>> alignLinks(List<LinkGene> unsortedA, List<LinkGene> unsortedB) {
        List<LinkGene> a = sortedByInnovation(unsortedA);
        List<LinkGene> b = sortedByInnovation(unsortedB);
        List<Pair<LinkGene>> pairs = new ArrayList<>(a.size() + b.size());
        int i = 0;
        int j = 0;
        while (i < a.size() && j < b.size()) {
            int comparison = Long.compare(a.get(i).innovation(), b.get(j).innovation());
            LinkGene ofA = comparison <= 0 ? a.get(i++) : null;
            LinkGene ofB = comparison >= 0 ? b.get(j++) : null;
            pairs.add(new Pair<>(ofA, ofB));
        }
        a.subList(i, a.size()).forEach(link -> pairs.add(new Pair<>(link, null)));
        b.subList(j, b.size()).forEach(link -> pairs.add(new Pair<>(null, link)));
        return pairs;
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
