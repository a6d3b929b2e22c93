package mmneat.evolution;

import java.util.Arrays;

/**
 * A statistic that summarises several scores in one: those of the trials of an evaluation, or of the members of a
 * population.
 *
 * <p>Source: docs/specification/evolution.md, section 1.3, and docs/specification/original-options.md, section 4.7.
 */
public enum ScoreStatistic {

    /** The running mean, computed as in the original so that every bit is the same. */
    AVERAGE("Average") {
        @Override
        public double of(double... scores) {
            return SampleStatistics.meanOf(scores);
        }
    },

    /** The maximum. */
    MAX("Max") {
        @Override
        public double of(double... scores) {
            SampleStatistics.requireValues(scores, "take the maximum of");
            return Arrays.stream(scores).max().orElseThrow();
        }
    },

    /** The minimum. */
    MIN("Min") {
        @Override
        public double of(double... scores) {
            SampleStatistics.requireValues(scores, "take the minimum of");
            return Arrays.stream(scores).min().orElseThrow();
        }
    },

    /** The median; the mean of the two middle values if the number of values is even. */
    MEDIAN("Median") {
        @Override
        public double of(double... scores) {
            double[] sorted = sorted(scores, "take the median of");
            int middle = sorted.length / 2;
            return sorted.length % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
        }
    },

    /**
     * The 75th percentile, at position 0.75 (n + 1) of n sorted values, interpolated linearly between two neighbours.
     */
    UPPER_QUARTILE("UpperQuartile") {
        @Override
        public double of(double... scores) {
            double[] sorted = sorted(scores, "take the upper quartile of");
            double position = 0.75 * (sorted.length + 1);
            int below = (int) position;
            if (below < 1) {
                return sorted[0];
            }
            if (below >= sorted.length) {
                return sorted[sorted.length - 1];
            }
            return sorted[below - 1] + (position - below) * (sorted[below] - sorted[below - 1]);
        }
    },

    /**
     * The mode. In ascending order, values less than 0.001 above the first value of a group belong to that group and
     * count as that value. Of equally frequent groups, the one with the largest values is chosen.
     */
    MODE("Mode") {
        @Override
        public double of(double... scores) {
            double[] sorted = sorted(scores, "take the most frequent of");
            double mode = sorted[0];
            int modeCount = 0;
            int start = 0;
            for (int i = 0; i < sorted.length; i++) {
                if (sorted[i] - sorted[start] >= GROUP_WIDTH) {
                    start = i;
                }
                int count = i - start + 1;
                if (count >= modeCount) {
                    mode = sorted[start];
                    modeCount = count;
                }
            }
            return mode;
        }
    };

    private static final double GROUP_WIDTH = 0.001;

    private final String label;

    ScoreStatistic(String label) {
        this.label = label;
    }

    private static double[] sorted(double[] scores, String purpose) {
        SampleStatistics.requireValues(scores, purpose);
        double[] sorted = scores.clone();
        Arrays.sort(sorted);
        return sorted;
    }

    /**
     * The statistic with the original's name.
     *
     * @throws IllegalArgumentException if there is none
     */
    public static ScoreStatistic named(String label) {
        return Arrays.stream(values())
                .filter(statistic -> statistic.label.equals(label))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("no statistic is called " + label));
    }

    /** The original's name, for example {@code Average}. */
    public String label() {
        return label;
    }

    /**
     * The statistic of at least one score.
     *
     * @throws IllegalArgumentException if there is none
     */
    public abstract double of(double... scores);
}
