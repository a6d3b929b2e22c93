package mmneat.neat.network;

/** The decision from approximate sums which neuron has the highest activation. */
final class HighestSum {

    /** Returned if the sums are too close. */
    static final int UNCLEAR = -1;

    private HighestSum() {}

    /**
     * The index of the sum with the highest tanh, as far as it is clear.
     *
     * @param count number of sums
     * @param margin how far each may be from the exact sum
     * @return {@link #UNCLEAR} if two could have the same tanh, or the highest is near -1
     */
    static int of(double[] sums, int count, double margin) {
        /*
         * tanh rises, so the highest sum mostly tells the highest activation. Rounding, by less than 2 units in the
         * last place or 2.3e-16 of our tanh, could make two activations equal or swap them only if the sums are close
         * together or both far out: for u > l + d, u > -b and l < b (d at most 1), tanh(u) - tanh(l) is more than d (1
         * - tanh(b + 1)^2), which is
         *
         *   d = 1e-9, b = 5     2e-14
         *   d = 1e-2, b = 13    3e-14.
         */
        int best = 0;
        double second = Double.NEGATIVE_INFINITY;
        for (int i = 1; i < count; i++) {
            // A sum that is not a number stays the second one.
            second = Math.max(second, Math.min(sums[best], sums[i]));
            best = sums[i] > sums[best] ? i : best;
        }
        double difference = sums[best] - second - 2 * margin;
        boolean clear = difference > 1e-9 && sums[best] > -5 && second < 5
                || difference > 1e-2 && sums[best] > -13 && second < 13;
        return clear ? best : UNCLEAR;
    }
}
