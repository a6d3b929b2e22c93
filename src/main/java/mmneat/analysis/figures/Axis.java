package mmneat.analysis.figures;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * The range of an axis, with ticks at multiples of 1, 2 or 5 times a power of ten.
 *
 * @param low smallest value, finite
 * @param high largest value, finite and larger than {@code low}
 */
record Axis(double low, double high) {

    /** Larger numbers are clamped to this one, because their differences would overflow. */
    private static final double LARGEST = 1e300;

    /** From this number on, labels are in scientific notation. */
    private static final double LARGEST_WRITTEN_OUT = 1e7;

    private static final double SMALLEST_WRITTEN_OUT = 1e-4;

    /**
     * An axis that covers at least this range. An empty range, or one too small for the precision of its numbers, is
     * widened upwards.
     */
    static Axis of(double low, double high) {
        double bottom = finite(low);
        double top = finite(high);
        double least = Math.max(1e-12, 1e-9 * Math.abs(bottom));
        return new Axis(bottom, top - bottom >= least ? top : bottom + Math.max(1, 1e-6 * Math.abs(bottom)));
    }

    private static double finite(double value) {
        return Double.isNaN(value) ? 0 : Math.max(-LARGEST, Math.min(LARGEST, value));
    }

    /** The place of a value on the axis: 0 at its low end, 1 at its high end. */
    double share(double value) {
        return (value - low) / (high - low);
    }

    /**
     * Values of ticks, ascending, both ends included.
     *
     * @param most maximum number of ticks, at least 2
     */
    List<Double> ticks(int most) {
        double step = step(most);
        double slack = step * 1e-6;
        List<Double> ticks = new ArrayList<>();
        double first = Math.ceil((low - slack) / step);
        for (int i = 0; i <= most && (first + i) * step <= high + slack; i++) {
            ticks.add((first + i) * step);
        }
        return ticks;
    }

    private double step(int most) {
        double least = (high - low) / most;
        double unit = Math.pow(10, Math.floor(Math.log10(least)));
        for (int factor : new int[] {1, 2, 5}) {
            if (factor * unit >= least) {
                return factor * unit;
            }
        }
        return 10 * unit;
    }

    /**
     * The label of a tick.
     *
     * @param most maximum number of ticks; labels have enough digits to distinguish them
     */
    String label(double tick, int most) {
        double largest = Math.max(Math.abs(low), Math.abs(high));
        double step = step(most);
        int decimals = (int) Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
        String pattern = decimals == 0 ? "#,##0" : "#,##0." + "0".repeat(decimals);
        if (largest >= LARGEST_WRITTEN_OUT || step < SMALLEST_WRITTEN_OUT) {
            // As many digits as tell neighbouring ticks apart.
            int digits = (int) Math.max(1, Math.min(15, Math.ceil(Math.log10(largest / step))));
            pattern = "0." + "#".repeat(digits) + "E0";
        }
        double value = Math.abs(tick) < step / 2 ? 0 : tick;
        return value == 0
                ? "0"
                : new DecimalFormat(pattern, DecimalFormatSymbols.getInstance(Locale.ROOT)).format(value);
    }
}
