package mmneat.neat.variation;

import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.random.ResumableRandom;

/**
 * Adds a standard normal number to the weight of one random link. The original uses it if {@code perLinkMutateRate} is
 * 0.
 *
 * <p>Source: docs/specification/networks.md, section 8.2.
 */
final class OneWeightMutation implements MutationOperator {

    @Override
    public String logName() {
        return "WeightPerturbationMutation";
    }

    @Override
    public boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        int chosen = Draws.changeableLink(offspring.links(), random);
        if (chosen < 0) {
            return false;
        }
        LinkGene link = offspring.links().get(chosen);
        offspring.links().set(chosen, link.withWeight(link.weight() + random.nextGaussian()));
        return true;
    }
}
