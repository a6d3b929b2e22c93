package mmneat.analysis.statistics;

import java.util.Locale;
import org.jspecify.annotations.Nullable;

/** The format of numbers in tables, the same for every locale of the machine. */
public final class Numbers {

    private Numbers() {}

    /** From this number on, scores are written with an exponent. */
    private static final double LARGE = 1e9;

    /**
     * Formats a score. From 100 on and for whole numbers: no decimals, and commas between groups of three digits.
     * Otherwise: at most four significant digits. From a billion on: with an exponent. NaN: a dash. Negative scores: by
     * their absolute value.
     */
    public static String score(double value) {
        if (Double.isNaN(value)) {
            return "-";
        }
        if (Math.abs(value) >= LARGE && !Double.isInfinite(value)) {
            return String.format(Locale.ROOT, "%.3e", value).replaceFirst("\\.?0+e", "e");
        }
        return Math.abs(value) >= 100 || value == Math.rint(value)
                ? String.format(Locale.ROOT, "%,.0f", value)
                : String.format(Locale.ROOT, "%.4g", value)
                        .replaceFirst("(\\.\\d*?)0+$", "$1")
                        .replaceFirst("\\.$", "");
    }

    /** A score, or a dash for one that is undefined. */
    public static String score(@Nullable Double value) {
        return score(value == null ? Double.NaN : value.doubleValue());
    }

    /** An interval of scores, or a dash for one that is undefined. */
    public static String interval(@Nullable Double low, @Nullable Double high) {
        return low == null || high == null || low.isNaN() ? "-" : score(low) + " to " + score(high);
    }

    /** A number of things, "1 run" or "2 runs". */
    public static String counted(int count, String thing) {
        return count + " " + thing + (count == 1 ? "" : "s");
    }

    /** A probability with two or three significant digits; scientific below 0.0001. */
    public static String probability(double p) {
        if (Double.isNaN(p)) {
            return "-";
        }
        if (p >= 1) {
            return "1";
        }
        return String.format(Locale.ROOT, p < 0.0001 ? "%.1e" : p < 0.001 ? "%.5f" : p < 0.1 ? "%.4f" : "%.3f", p);
    }

    /** A number with the given number of decimals; a dash for NaN. */
    public static String decimal(double value, int decimals) {
        return Double.isNaN(value) ? "-" : String.format(Locale.ROOT, "%." + decimals + "f", value);
    }
}
