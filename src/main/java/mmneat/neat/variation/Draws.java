package mmneat.neat.variation;

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
        return java.util.Arrays.copyOf(shuffled, count);
    }
}
