package mmneat.analysis.statistics;

import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.special.Gamma;
import org.apache.commons.math3.stat.ranking.NaturalRanking;
import org.apache.commons.math3.stat.ranking.TiesStrategy;

/**
 * Result of the Kruskal-Wallis rank sum test: do the samples come from one distribution?
 *
 * <p>As R's {@code kruskal.test} (docs/specification/evolution.md, section 8). No library of the build offers the test.
 *
 * @param h the statistic, corrected for ties; NaN if all values are equal
 * @param degreesOfFreedom number of samples - 1
 * @param p from the chi-square distribution; NaN if h is
 * @param tieCorrection the divisor 1 - sum(t^3 - t) / (N^3 - N); 1 without ties, 0 if all values are equal
 */
public record KruskalWallis(double h, int degreesOfFreedom, double p, double tieCorrection) {

    /**
     * Tests two or more samples.
     *
     * @throws IllegalArgumentException for fewer than two samples
     */
    public static KruskalWallis of(List<Sample> samples) {
        if (samples.size() < 2) {
            throw new IllegalArgumentException("the Kruskal-Wallis test compares at least two samples");
        }
        double[] pooled =
                samples.stream().flatMapToDouble(s -> Arrays.stream(s.values())).toArray();
        double[] ranks = new NaturalRanking(TiesStrategy.AVERAGE).rank(pooled);
        double total = pooled.length;
        // Squared deviations of the mean ranks instead of the usual 12 / (N (N + 1)) sum(R^2 / n) - 3 (N + 1), which
        // subtracts numbers of almost the same size.
        double between = 0;
        int first = 0;
        for (Sample sample : samples) {
            double rankSum = 0;
            for (int i = first; i < first + sample.size(); i++) {
                rankSum += ranks[i];
            }
            first += sample.size();
            double deviation = rankSum / sample.size() - (total + 1) / 2;
            between += sample.size() * deviation * deviation;
        }
        double correction = 1 - tieSum(pooled) / (total * total * total - total);
        double h = correction == 0 ? Double.NaN : 12 / (total * (total + 1)) * between / correction;
        int degreesOfFreedom = samples.size() - 1;
        return new KruskalWallis(h, degreesOfFreedom, chiSquareTail(h, degreesOfFreedom), correction);
    }

    /** The probability that a chi-square variable exceeds {@code h}. */
    public static double chiSquareTail(double h, int degreesOfFreedom) {
        return Double.isNaN(h) ? Double.NaN : Gamma.regularizedGammaQ(degreesOfFreedom / 2.0, h / 2);
    }

    /** Sum of t^3 - t over the groups of t equal values. */
    private static double tieSum(double[] values) {
        double[] ordered = values.clone();
        Arrays.sort(ordered);
        double sum = 0;
        int start = 0;
        for (int i = 1; i <= ordered.length; i++) {
            if (i == ordered.length || ordered[i] != ordered[start]) {
                double t = i - start;
                sum += t * t * t - t;
                start = i;
            }
        }
        return sum;
    }
}
