package mmneat.neat.variation;

import java.util.Arrays;
import java.util.List;
import mmneat.neat.LinkGene;
import mmneat.random.ResumableRandom;

/** Random draws used by the variation operators. Source: docs/specification/networks.md, section 2. */
final class Draws {

    private Draws() {}

    /** Uniform on [-1, 1): the weight of a new link. */
    static double smallWeight(ResumableRandom random) {
        return random.nextDouble() * 2 - 1;
    }

    /** Shuffles the numbers 0..size-1 completely, with size - 1 draws, and returns the first {@code count}. */
    static int[] distinct(int count, int size, ResumableRandom random) {
        int[] shuffled = new int[size];
        for (int i = 0; i < size; i++) {
            shuffled[i] = i;
        }
        for (int i = size; i > 1; i--) {
            int other = random.nextInt(i);
            int value = shuffled[i - 1];
            shuffled[i - 1] = shuffled[other];
            shuffled[other] = value;
        }
        return Arrays.copyOf(shuffled, count);
    }

    /**
     * Returns the index of a random link that is active and not frozen, with one draw; -1 without a draw if there is
     * none.
     */
    static int changeableLink(List<LinkGene> links, ResumableRandom random) {
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
