package mmneat.analysis.statistics;

import java.util.Arrays;
import java.util.Objects;

/**
 * One group of measurements, for example the average scores of a method's champions.
 *
 * @param label what the group is called in tables
 * @param values the measurements, at least one, all finite, in any order
 */
public record Sample(String label, double[] values) {

    public Sample {
        Objects.requireNonNull(label, "label");
        if (values.length == 0) {
            throw new IllegalArgumentException("the sample '" + label + "' has no values");
        }
        for (double value : values) {
            if (!Double.isFinite(value)) {
                throw new IllegalArgumentException("the sample '" + label + "' holds " + value);
            }
        }
        values = values.clone();
    }

    @Override
    public double[] values() {
        return values.clone();
    }

    public int size() {
        return values.length;
    }

    /** The arithmetic mean. */
    public double mean() {
        return Arrays.stream(values).sum() / values.length;
    }

    /** The deviation with n - 1; NaN for a single value. */
    public double standardDeviation() {
        double mean = mean();
        double squares = 0;
        for (double value : values) {
            squares += (value - mean) * (value - mean);
        }
        return Math.sqrt(squares / (values.length - 1));
    }

    public double median() {
        return quantile(0.5);
    }

    /**
     * The quantile with linear interpolation between the ordered values (R's type 7).
     *
     * @param probability in [0, 1]
     */
    public double quantile(double probability) {
        double[] ordered = values.clone();
        Arrays.sort(ordered);
        return quantileOfOrdered(ordered, probability);
    }

    static double quantileOfOrdered(double[] ordered, double probability) {
        double position = probability * (ordered.length - 1);
        int below = (int) Math.floor(position);
        int above = Math.min(below + 1, ordered.length - 1);
        return ordered[below] + (position - below) * (ordered[above] - ordered[below]);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Sample sample && label.equals(sample.label) && Arrays.equals(values, sample.values);
    }

    @Override
    public int hashCode() {
        return 31 * label.hashCode() + Arrays.hashCode(values);
    }

    @Override
    public String toString() {
        return label + Arrays.toString(values);
    }
}
