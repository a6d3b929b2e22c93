package mmneat.nsga2;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/**
 * A population sorted into fronts, with crowding distances. Individuals are named by their index in the score array.
 *
 * <p>Source: Deb et al. 2002, section III; docs/specification/evolution.md, sections 2.2 and 2.3.
 */
public final class NondominatedSorting {

    private final int[] order;
    private final List<int[]> fronts;
    private final int[] rank;
    private final double[] crowding;

    private NondominatedSorting(int[] order, List<int[]> fronts, int[] rank, double[] crowding) {
        this.order = order;
        this.fronts = List.copyOf(fronts);
        this.rank = rank;
        this.crowding = crowding;
    }

    /**
     * Sorts a population.
     *
     * @param scores {@code scores[individual][objective]}, all maximised, all of one length
     * @param crowding among whom the crowding distance is measured
     * @throws IllegalArgumentException if score vectors differ in length or a score is not finite
     * @throws NullPointerException if the crowding is missing
     */
    public static NondominatedSorting of(double[][] scores, Crowding crowding) {
        Objects.requireNonNull(crowding, "crowding");
        requireComparable(scores);
        return crowding.sort(scores);
    }

    /*
     * Fast nondominated sorting: each pair is compared once, and who is dominated by none but members of earlier fronts makes
     * up the next. Within a front the members stand as in `order`.
     */
    static NondominatedSorting of(double[][] scores, int[] order, double[] crowding) {
        int size = scores.length;
        boolean[][] dominates = new boolean[size][size];
        int[] dominators = new int[size];
        for (int a = 0; a < size; a++) {
            for (int b = 0; b < size; b++) {
                if (Dominance.dominatesUnchecked(scores[a], scores[b])) {
                    dominates[a][b] = true;
                    dominators[b]++;
                }
            }
        }
        int[] rank = new int[size];
        List<int[]> fronts = new ArrayList<>();
        int[] remaining = order;
        while (remaining.length > 0) {
            int[] front = withDominators(remaining, dominators, true);
            remaining = withDominators(remaining, dominators, false);
            for (int member : front) {
                rank[member] = fronts.size();
                for (int other : remaining) {
                    if (dominates[member][other]) {
                        dominators[other]--;
                    }
                }
            }
            fronts.add(front);
        }
        return new NondominatedSorting(order, fronts, rank, crowding);
    }

    private static int[] withDominators(int[] individuals, int[] dominators, boolean none) {
        int[] chosen = new int[individuals.length];
        int count = 0;
        for (int individual : individuals) {
            if (dominators[individual] == 0 == none) {
                chosen[count++] = individual;
            }
        }
        return Arrays.copyOf(chosen, count);
    }

    /** Refuses score vectors of different lengths, and scores that are not finite. */
    static void requireComparable(double[][] scores) {
        for (int i = 0; i < scores.length; i++) {
            if (scores[i].length != scores[0].length) {
                throw new IllegalArgumentException("individual " + i + " has " + scores[i].length
                        + " objectives, individual 0 has " + scores[0].length);
            }
            for (int objective = 0; objective < scores[i].length; objective++) {
                if (!Double.isFinite(scores[i][objective])) {
                    throw new IllegalArgumentException("individual " + i + ": score of objective " + objective
                            + " must be a finite number, is " + scores[i][objective]);
                }
            }
        }
    }

    /** Number of individuals. */
    public int size() {
        return order.length;
    }

    /**
     * The individual at a position of the order in which the population is left by the crowding computation.
     *
     * @throws IndexOutOfBoundsException if there is no such position
     */
    public int individualAt(int position) {
        return order[position];
    }

    /** Fronts from the best on, each with its members (copies). */
    public List<int[]> fronts() {
        return fronts.stream().map(int[]::clone).toList();
    }

    /** The fronts themselves, for selection, which leaves them as they are. */
    List<int[]> sharedFronts() {
        return fronts;
    }

    /**
     * Front of an individual, from 0.
     *
     * @throws IndexOutOfBoundsException if there is no such individual
     */
    public int rank(int individual) {
        return rank[individual];
    }

    /**
     * Crowding distance of an individual; {@link Double#POSITIVE_INFINITY} at the ends.
     *
     * @throws IndexOutOfBoundsException if there is no such individual
     */
    public double crowding(int individual) {
        return crowding[individual];
    }
}
