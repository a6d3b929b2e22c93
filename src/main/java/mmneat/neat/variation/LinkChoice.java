package mmneat.neat.variation;

import java.util.List;
import mmneat.neat.LinkGene;
import mmneat.random.ResumableRandom;

/** Uniform random choice of a link that mutation may change. */
final class LinkChoice {

    private LinkChoice() {}

    /**
     * Returns the index of a random link that is active and not frozen, with one draw; -1 without a draw if there is
     * none.
     */
    static int amongActiveAndUnfrozen(List<LinkGene> links, ResumableRandom random) {
        int[] candidates = new int[links.size()];
        int count = 0;
        for (int i = 0; i < links.size(); i++) {
            if (links.get(i).active() && !links.get(i).frozen()) {
                candidates[count++] = i;
            }
        }
        return count == 0 ? -1 : candidates[random.nextInt(count)];
    }
}
