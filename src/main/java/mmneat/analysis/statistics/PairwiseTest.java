package mmneat.analysis.statistics;

import java.util.Arrays;
import org.apache.commons.statistics.inference.ContinuityCorrection;
import org.apache.commons.statistics.inference.MannWhitneyUTest;
import org.apache.commons.statistics.inference.PValueMethod;

/**
 * Two-sided Mann-Whitney U test of two samples. The method of computing p is chosen as by R's {@code wilcox.test}:
 * exact if both samples have fewer than 50 values and no value occurs twice in the two samples together; otherwise the
 * normal approximation with continuity correction and tie-corrected variance (docs/specification/evolution.md, section
 * 8). Commons Statistics computes the probabilities.
 *
 * @param a label of the first sample
 * @param b label of the second sample
 * @param u number of pairs in which the first sample's value is larger, plus half the ties (R's W)
 * @param ties whether any two values of the pooled pair are equal
 * @param method how p was computed
 * @param p two-sided; NaN if all values are equal
 * @param effectSize Vargha and Delaney's A: the probability that a value of the first sample is the larger, ties
 *     counted half; 0.5 means no effect
 */
public record PairwiseTest(String a, String b, double u, boolean ties, Method method, double p, double effectSize) {

    /** The method of computing p. */
    public enum Method {
        /** The exact distribution of U. */
        EXACT,
        /** The normal approximation, with continuity correction and tie-corrected variance. */
        NORMAL
    }

    /** Samples of this size or more are always compared by the normal approximation. */
    private static final int NORMAL_FROM_SIZE = 50;

    public static PairwiseTest of(Sample a, Sample b) {
        double[] x = a.values();
        double[] y = b.values();
        boolean ties = hasTies(x, y);
        Method method =
                ties || x.length >= NORMAL_FROM_SIZE || y.length >= NORMAL_FROM_SIZE ? Method.NORMAL : Method.EXACT;
        double u = pairsWon(x, y);
        double p = allEqual(x, y) ? Double.NaN : method == Method.EXACT ? exact(x, y) : normal(x, y, u);
        return new PairwiseTest(a.label(), b.label(), u, ties, method, p, u / ((double) x.length * y.length));
    }

    /** The rank-biserial correlation, 2A - 1, in [-1, 1]. */
    public double rankBiserial() {
        return 2 * effectSize - 1;
    }

    /**
     * The usual word for the size of the effect, by d = |A - 0.5|: negligible for d below 0.06, small below 0.14,
     * medium below 0.21, and large from there on (Vargha and Delaney 2000).
     */
    public String magnitude() {
        double distance = Math.abs(effectSize - 0.5);
        return distance < 0.06 ? "negligible" : distance < 0.14 ? "small" : distance < 0.21 ? "medium" : "large";
    }

    static double exact(double[] x, double[] y) {
        return MannWhitneyUTest.withDefaults()
                .with(PValueMethod.EXACT)
                .test(x, y)
                .getPValue();
    }

    private static double normal(double[] x, double[] y, double u) {
        // At the exact middle, R's correction is sign(0) = 0. Half a step would give a p above 1, which is cut to 1.
        if (2 * u == (double) x.length * y.length) {
            return 1;
        }
        return MannWhitneyUTest.withDefaults()
                .with(PValueMethod.ASYMPTOTIC)
                .with(ContinuityCorrection.ENABLED)
                .test(x, y)
                .getPValue();
    }

    private static double pairsWon(double[] x, double[] y) {
        double won = 0;
        for (double mine : x) {
            for (double other : y) {
                won += mine > other ? 1 : mine == other ? 0.5 : 0;
            }
        }
        return won;
    }

    private static boolean hasTies(double[] x, double[] y) {
        double[] pooled = pool(x, y);
        for (int i = 1; i < pooled.length; i++) {
            if (pooled[i] == pooled[i - 1]) {
                return true;
            }
        }
        return false;
    }

    private static boolean allEqual(double[] x, double[] y) {
        double[] pooled = pool(x, y);
        return pooled[0] == pooled[pooled.length - 1];
    }

    private static double[] pool(double[] x, double[] y) {
        double[] pooled = Arrays.copyOf(x, x.length + y.length);
        System.arraycopy(y, 0, pooled, x.length, y.length);
        Arrays.sort(pooled);
        return pooled;
    }
}
