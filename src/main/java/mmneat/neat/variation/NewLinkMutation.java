package mmneat.neat.variation;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.NodeGene;
import mmneat.random.ResumableRandom;

/**
 * Adds a link from a random neuron to a random target. Targets are outputs, and hidden neurons that have outgoing
 * links; frozen neurons are none. If the two are already linked, nothing is added and there is no second attempt.
 *
 * <p>Source: docs/specification/networks.md, section 8.3.
 */
final class NewLinkMutation implements MutationOperator {

    @Override
    public String logName() {
        return "NewLinkMutation";
    }

    @Override
    public boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        List<NodeGene> nodes = offspring.nodes();
        int source = random.nextInt(nodes.size());
        double weight = Draws.smallWeight(random);
        Long[] targets = possibleTargets(offspring);
        if (targets.length == 0) {
            return false;
        }
        long target = targets[random.nextInt(targets.length)];
        long innovation = pool.takeInnovation();
        long sourceInnovation = nodes.get(source).innovation();
        if (!offspring.hasLink(sourceInnovation, target)) {
            boolean isRecurrent = offspring.indexOf(target) <= source;
            offspring.links().add(new LinkGene(innovation, sourceInnovation, target, weight, isRecurrent));
        }
        return true;
    }

    /** Returns the possible targets of a link. A hidden neuron must have outgoing links; inactive ones count. */
    private static Long[] possibleTargets(GenotypeDraft offspring) {
        List<NodeGene> nodes = offspring.nodes();
        Set<Long> inputsAndFrozen = new HashSet<>();
        for (int i = 0; i < nodes.size(); i++) {
            if (i < offspring.inputs() || nodes.get(i).frozen()) {
                inputsAndFrozen.add(nodes.get(i).innovation());
            }
        }
        // The original draws from the iteration order of this hash set, which depends on how it was filled.
        Set<Long> targets = new HashSet<>();
        for (LinkGene link : offspring.links()) {
            if (!inputsAndFrozen.contains(link.source())) {
                targets.add(link.source());
            }
        }
        for (int i = offspring.firstOutput(); i < nodes.size(); i++) {
            if (!nodes.get(i).frozen()) {
                targets.add(nodes.get(i).innovation());
            }
        }
        return targets.toArray(new Long[0]);
    }
}
