package mmneat.evolution;

import java.util.Arrays;

/**
 * How the scores of several trials become one.
 *
 * <p>Source: docs/specification/evolution.md, section 1.3.
 */
public enum TrialStatistic {

    /** The running mean, in the original's form, so that the last bit is the same. */
    AVERAGE("Average") {
        @Override
        public double of(double... trials) {
            return SampleStatistics.meanOf(trials);
        }
    },

    /** The largest. */
    MAX("Max") {
        @Override
        public double of(double... trials) {
            SampleStatistics.requireValues(trials, "take the largest of");
            return Arrays.stream(trials).max().orElseThrow();
        }
    },

    /**
     * The most frequent. In ascending order, values less than 0.001 above the first of a group belong to it and count as it;
     * of equally frequent groups the largest wins.
     */
    MODE("Mode") {
        @Override
        public double of(double... trials) {
            SampleStatistics.requireValues(trials, "take the most frequent of");
            double[] sorted = trials.clone();
            Arrays.sort(sorted);
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

    TrialStatistic(String label) {
        this.label = label;
    }

    /** The original's name: {@code Average}, {@code Max} or {@code Mode}. */
    public String label() {
        return label;
    }

    /**
     * The statistic of the scores of at least one trial.
     *
     * @throws IllegalArgumentException if there is none
     */
    public abstract double of(double... trials);
}
