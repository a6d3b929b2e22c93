package mmneat.analysis.statistics;

import java.util.Arrays;
import java.util.Objects;
import org.apache.commons.statistics.descriptive.Mean;
import org.apache.commons.statistics.descriptive.Quantile;
import org.apache.commons.statistics.descriptive.StandardDeviation;

/**
 * One group of measurements, for example the average scores of a method's champions.
 *
 * @param label what the group is called in tables
 * @param values the measurements, at least one, all finite, in any order
 */
public record Sample(String label, double[] values) {

    private static final Quantile QUANTILES =
            Quantile.withDefaults().with(Quantile.EstimationMethod.HF7).withCopy(true);

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
        return Mean.of(values).getAsDouble();
    }

    /** The deviation with n - 1; NaN for a single value. */
    public double standardDeviation() {
        return values.length < 2 ? Double.NaN : StandardDeviation.of(values).getAsDouble();
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
        return quantile(values, probability);
    }

    /** The quantile of values in any order, which stay as they are. */
    static double quantile(double[] values, double probability) {
        return QUANTILES.evaluate(values, probability);
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
