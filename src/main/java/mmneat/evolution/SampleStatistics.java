package mmneat.evolution;

import java.util.Arrays;

/**
 * Minimum, mean, maximum and standard deviation of a sample, summed in the original's order so that every bit is the
 * same.
 *
 * <p>Source: docs/specification/evolution.md, sections 1.3 and 5.2.
 *
 * @param min the minimum
 * @param mean the running mean
 * @param max the maximum
 * @param deviation the sample standard deviation (n - 1); NaN for a single value
 */
public record SampleStatistics(double min, double mean, double max, double deviation) {

    /**
     * Statistics of at least one value.
     *
     * @throws IllegalArgumentException if there is none
     */
    public static SampleStatistics of(double... sample) {
        requireValues(sample, "describe");
        return new SampleStatistics(
                Arrays.stream(sample).min().orElseThrow(),
                meanOf(sample),
                Arrays.stream(sample).max().orElseThrow(),
                StrictMath.sqrt(varianceOf(sample)));
    }

    /**
     * Running mean of at least one value.
     *
     * @throws IllegalArgumentException if there is none
     */
    public static double meanOf(double... sample) {
        requireValues(sample, "average");
        double mean = 0;
        for (int i = 0; i < sample.length; i++) {
            mean += (sample[i] - mean) / (i + 1);
        }
        return mean;
    }

    /**
     * Sample variance (n - 1) of at least one value; NaN for a single one.
     *
     * @throws IllegalArgumentException if there is none
     */
    public static double varianceOf(double... sample) {
        requireValues(sample, "take the variance of");
        double mean = 0;
        double squares = 0;
        for (int i = 0; i < sample.length; i++) {
            double previous = mean;
            mean += (sample[i] - mean) / (i + 1);
            squares += (sample[i] - mean) * (sample[i] - previous);
        }
        return squares / (sample.length - 1);
    }

    static void requireValues(double[] sample, String purpose) {
        if (sample.length == 0) {
            throw new IllegalArgumentException("no values to " + purpose);
        }
    }
}
