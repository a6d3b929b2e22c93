package mmneat.neat.variation;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.random.ResumableRandom;

/**
 * Unfreezes the whole network, then freezes its policy neurons or its preference neurons and everything upstream of
 * them. The upstream search does not pass through other outputs. Frozen links keep their weights and are not spliced;
 * frozen neurons get no new links.
 *
 * <p>Source: docs/specification/networks.md, section 8.7.
 */
record FreezeMutation(Part part) implements MutationOperator {

    /** The part of the network to freeze. */
    enum Part {
        /** The policy neurons and everything upstream of them. */
        POLICY("FreezePolicyMutation"),
        /** The preference neurons and everything upstream of them. */
        PREFERENCE("FreezePreferenceMutation"),
        /** The preference neurons if the policy neurons are frozen, else the policy neurons. */
        ALTERNATE("FreezeAlternateMutation");

        private final String logName;

        Part(String logName) {
            this.logName = logName;
        }
    }

    @Override
    public String logName() {
        return part.logName;
    }

    @Override
    public boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        boolean isPreferenceFrozen = part == Part.PREFERENCE
                || (part == Part.ALTERNATE && offspring.output(0).frozen());
        Set<Long> frozenNodes = upstreamOf(chosenOutputs(offspring, isPreferenceFrozen), offspring);
        offspring.nodes().replaceAll(node -> node.withFrozen(frozenNodes.contains(node.innovation())));
        offspring.links().replaceAll(link -> link.withFrozen(frozenNodes.contains(link.target())));
        return true;
    }

    private static Set<Long> chosenOutputs(GenotypeDraft offspring, boolean isPreference) {
        Set<Long> chosen = new HashSet<>();
        ModuleLayout layout = offspring.layout();
        for (int output = 0; output < offspring.outputs(); output++) {
            if (layout.isPreference(output) == isPreference) {
                chosen.add(offspring.output(output).innovation());
            }
        }
        return chosen;
    }

    private static Set<Long> upstreamOf(Set<Long> chosen, GenotypeDraft offspring) {
        List<NodeGene> nodes = offspring.nodes();
        Set<Long> outputs = new HashSet<>();
        nodes.subList(offspring.firstOutput(), nodes.size()).forEach(node -> outputs.add(node.innovation()));
        Set<Long> reached = new HashSet<>(chosen);
        Deque<Long> toVisit = new ArrayDeque<>(chosen);
        while (!toVisit.isEmpty()) {
            long target = toVisit.remove();
            for (LinkGene link : offspring.links()) {
                if (link.target() == target && !outputs.contains(link.source()) && reached.add(link.source())) {
                    toVisit.add(link.source());
                }
            }
        }
        return reached;
    }
}
