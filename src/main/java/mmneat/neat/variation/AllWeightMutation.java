package mmneat.neat.variation;

import java.util.List;
import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.random.ResumableRandom;

/**
 * Adds a standard normal number to each weight with a given probability. Inactive links are included; frozen links are
 * skipped without a draw. Weights are unbounded.
 *
 * <p>Source: docs/specification/networks.md, section 8.2.
 *
 * @param rate probability per link
 */
record AllWeightMutation(double rate) implements MutationOperator {

    @Override
    public String logName() {
        return "AllWeightMutation";
    }

    @Override
    public boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        List<LinkGene> links = offspring.links();
        for (int i = 0; i < links.size(); i++) {
            LinkGene link = links.get(i);
            if (!link.frozen() && random.nextDouble() < rate) {
                links.set(i, link.withWeight(link.weight() + random.nextGaussian()));
            }
        }
        return true;
    }
}
