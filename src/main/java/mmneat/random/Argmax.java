package mmneat.random;

import java.util.Arrays;

/**
 * The argmax with random ties by which modules and directions are chosen.
 *
 * <p>Source: docs/specification/networks.md, section 2.
 */
public final class Argmax {

    private Argmax() {}

    /**
     * One of the indices of the highest value, drawn by one {@code nextInt} also if there is only one. Values that are not
     * numbers are never the highest.
     *
     * @throws IllegalStateException if no value is a number
     */
    public static int of(double[] values, ResumableRandom random) {
        double highest = Double.NEGATIVE_INFINITY;
        int tied = 0;
        for (double value : values) {
            if (value > highest) {
                highest = value;
                tied = 0;
            }
            tied += value == highest ? 1 : 0;
        }
        if (tied == 0) {
            throw new IllegalStateException("preferences are not numbers: " + Arrays.toString(values));
        }
        int chosen = random.nextInt(tied);
        int index = -1;
        while (chosen >= 0) {
            index++;
            chosen -= values[index] == highest ? 1 : 0;
        }
        return index;
    }
}
