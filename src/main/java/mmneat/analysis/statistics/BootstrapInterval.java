package mmneat.analysis.statistics;

import mmneat.random.ResumableRandom;

/**
 * Percentile bootstrap interval of a sample's median (Efron 1979): the quantiles of the medians of samples drawn from
 * it with replacement.
 *
 * @param low lower end, one of the sample's order statistics or the mean of two
 * @param high upper end
 * @param level the nominal coverage, for example 0.95
 */
public record BootstrapInterval(double low, double high, double level) {

    private static final int RESAMPLES = 10_000;

    /**
     * Computes the interval from 10,000 drawn samples. The same sample, level and seed always give the same interval.
     *
     * @return ends NaN if the sample has fewer than two values
     */
    public static BootstrapInterval ofMedian(Sample sample, double level, long seed) {
        if (!(level > 0 && level < 1)) {
            throw new IllegalArgumentException("the level of an interval is between 0 and 1, not " + level);
        }
        if (sample.size() < 2) {
            return new BootstrapInterval(Double.NaN, Double.NaN, level);
        }
        ResumableRandom random = new ResumableRandom(seed);
        double[] values = sample.values();
        double[] drawn = new double[values.length];
        double[] medians = new double[RESAMPLES];
        for (int i = 0; i < RESAMPLES; i++) {
            for (int k = 0; k < drawn.length; k++) {
                drawn[k] = values[random.nextInt(values.length)];
            }
            medians[i] = Sample.quantile(drawn, 0.5);
        }
        double tail = (1 - level) / 2;
        return new BootstrapInterval(Sample.quantile(medians, tail), Sample.quantile(medians, 1 - tail), level);
    }
}
