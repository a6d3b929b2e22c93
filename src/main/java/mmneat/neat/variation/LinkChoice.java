package mmneat.neat.variation;

import java.util.List;
import mmneat.neat.LinkGene;
import mmneat.random.ResumableRandom;

/** Uniform choice of a link that may be changed. */
final class LinkChoice {

    private LinkChoice() {}

    /** Index of a random link that is active and not frozen: one draw; -1, without a draw, if there is none. */
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
