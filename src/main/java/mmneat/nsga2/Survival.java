package mmneat.nsga2;

import java.util.Arrays;

/**
 * Chooses who survives: whole fronts from the best on, and of the front that does not fit the least crowded. Nothing is drawn;
 * every tie is decided by the order of the scores.
 *
 * <p>Source: Deb et al. 2002, section III-C; spec/evolution.md, section 2.5.
 */
public final class Survival {

    private Survival() {}

    /**
     * The survivors.
     *
     * @param scores {@code scores[individual][objective]}: parents followed by children
     * @param count how many survive, at most all
     * @param crowding among whom the crowding distance is measured
     * @return indices of the survivors, in the order in which they are the next parents
     * @throws IllegalArgumentException if {@code count} is negative or more than all, or scores cannot be compared ({@link
     *     NondominatedSorting#of})
     * @throws NullPointerException if the crowding is missing
     */
    public static int[] survivors(double[][] scores, int count, Crowding crowding) {
        if (count < 0 || count > scores.length) {
            throw new IllegalArgumentException(count + " of " + scores.length + " individuals cannot survive");
        }
        NondominatedSorting sorting = NondominatedSorting.of(scores, crowding);
        int[] survivors = new int[count];
        int chosen = 0;
        for (int[] front : sorting.sharedFronts()) {
            int[] fitting = chosen + front.length <= count ? front : leastCrowded(front, count - chosen, sorting);
            System.arraycopy(fitting, 0, survivors, chosen, fitting.length);
            chosen += fitting.length;
        }
        return survivors;
    }

    /** The least crowded first; of equally crowded ones, those later in the front first. */
    private static int[] leastCrowded(int[] front, int count, NondominatedSorting sorting) {
        int[] ascending = ScoreOrder.ascending(front, sorting::crowding);
        int[] least = new int[count];
        Arrays.setAll(least, i -> ascending[ascending.length - 1 - i]);
        return least;
    }
}
