package mmneat.random;

import java.util.Arrays;

/**
 * The index of the largest of some values; of several largest values one is drawn at random. Networks choose the output
 * module with the highest preference in this way, and players the direction of movement with the highest output.
 *
 * <p>Source: docs/specification/networks.md, section 2.
 */
public final class Argmax {

    private Argmax() {}

    /**
     * Returns one of the indices of the highest value. It always draws exactly one {@code nextInt}, even if the highest
     * value is unique. NaN is never the highest value.
     *
     * @throws IllegalStateException if every value is NaN
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
            throw new IllegalStateException("preferences must be numbers, are " + Arrays.toString(values));
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
