package mmneat.cli.output;

import java.time.Duration;
import java.util.Locale;

/** Formats percentages, rates and durations. */
public final class QuantityText {

    private QuantityText() {}

    public static String percent(double portion) {
        return String.format(Locale.ROOT, "%.0f%%", portion * 100);
    }

    /** Formats simulated time steps per second. */
    public static String rate(double stepsPerSecond) {
        if (stepsPerSecond >= 1e6) {
            return String.format(Locale.ROOT, "%.1fM steps/s", stepsPerSecond / 1e6);
        }
        if (stepsPerSecond >= 1e3) {
            return String.format(Locale.ROOT, "%.0fk steps/s", stepsPerSecond / 1e3);
        }
        return String.format(Locale.ROOT, "%.0f steps/s", stepsPerSecond);
    }

    /** Formats a duration in its two largest units. */
    public static String duration(Duration time) {
        long seconds = Math.round(time.toMillis() / 1000.0);
        if (seconds < 60) {
            return seconds + " s";
        }
        if (seconds < 3600) {
            return seconds / 60 + " min " + seconds % 60 + " s";
        }
        if (seconds < 86400) {
            return seconds / 3600 + " h " + seconds % 3600 / 60 + " min";
        }
        return seconds / 86400 + " d " + seconds % 86400 / 3600 + " h";
    }
}
