package mmneat.neat.variation;

import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.random.ResumableRandom;

/**
 * Removes a random link, even if it is the only path to an output. Source: docs/specification/networks.md, section 8.7.
 */
final class DeleteLinkMutation implements MutationOperator {

    @Override
    public String logName() {
        return "DeleteLinkMutation";
    }

    @Override
    public boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        if (offspring.links().isEmpty()) {
            return false;
        }
        offspring.links().remove(random.nextInt(offspring.links().size()));
        return true;
    }
}
