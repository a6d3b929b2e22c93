package mmneat.nsga2;

import java.util.Arrays;

/**
 * Pareto dominance of score vectors, all objectives maximised.
 *
 * <p>Source: Deb et al. 2002, section III; docs/specification/evolution.md, section 2.1.
 */
public final class Dominance {

    private Dominance() {}

    /**
     * Whether {@code a} is at least as good as {@code b} in every objective and better in one. Equal vectors do not
     * dominate each other.
     *
     * @throws IllegalArgumentException if the vectors differ in length or contain NaN
     */
    public static boolean dominates(double[] a, double[] b) {
        if (a.length != b.length) {
            throw new IllegalArgumentException(
                    "score vectors must be equally long, have " + a.length + " and " + b.length + " objectives");
        }
        requireNumbers(a);
        requireNumbers(b);
        return dominatesUnchecked(a, b);
    }

    private static void requireNumbers(double[] scores) {
        for (double score : scores) {
            if (Double.isNaN(score)) {
                throw new IllegalArgumentException("scores must be numbers, are " + Arrays.toString(scores));
            }
        }
    }

    /** As {@link #dominates}, without checking the vectors. */
    static boolean dominatesUnchecked(double[] a, double[] b) {
        boolean better = false;
        for (int objective = 0; objective < a.length; objective++) {
            if (a[objective] < b[objective]) {
                return false;
            }
            better |= a[objective] > b[objective];
        }
        return better;
    }
}
