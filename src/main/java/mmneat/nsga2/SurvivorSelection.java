package mmneat.nsga2;

import java.util.Arrays;

/**
 * Survivor selection: complete fronts from the best on, then the least crowded members of the first front that does not
 * fit.
 *
 * <p>No random number is drawn; the order of the scores decides every tie.
 *
 * <p>Source: Deb et al. 2002, section III-C; docs/specification/evolution.md, section 2.5.
 */
public final class SurvivorSelection {

    private SurvivorSelection() {}

    /**
     * Selects the survivors.
     *
     * @param scores {@code scores[individual][objective]}: parents followed by children
     * @param count number of survivors, at most the number of individuals
     * @param crowding the individuals among which the crowding distance is measured
     * @return indices of the survivors, in the order in which they are the next parents
     * @throws IllegalArgumentException if {@code count} is negative or more than the number of individuals, or scores
     *     cannot be compared ({@link NondominatedSorting#of})
     * @throws NullPointerException if the crowding is missing
     */
    public static int[] survivors(double[][] scores, int count, Crowding crowding) {
        if (count < 0 || count > scores.length) {
            throw new IllegalArgumentException(
                    "number of survivors must be from 0 to " + scores.length + ", is " + count);
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

    /**
     * Returns the least crowded members of a front; of equally crowded members, those later in the front come first.
     */
    private static int[] leastCrowded(int[] front, int count, NondominatedSorting sorting) {
        int[] ascending = ScoreOrder.ascending(front, sorting::crowding);
        int[] least = new int[count];
        Arrays.setAll(least, i -> ascending[ascending.length - 1 - i]);
        return least;
    }
}
