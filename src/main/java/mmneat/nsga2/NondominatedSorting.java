package mmneat.nsga2;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/**
 * A population sorted into nondominated fronts, with crowding distances. Individuals are given by their index in the
 * scores.
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
     * @param crowding the individuals among which the crowding distance is measured
     * @throws IllegalArgumentException if score vectors differ in length or a score is not finite
     * @throws NullPointerException if the crowding is missing
     */
    public static NondominatedSorting of(double[][] scores, Crowding crowding) {
        Objects.requireNonNull(crowding, "crowding");
        requireComparable(scores);
        return crowding.sort(scores);
    }

    /** Sorts a population into fronts; within a front, individuals keep their places in {@code order}. */
    static NondominatedSorting of(double[][] scores, int[] order, double[] crowding) {
        int[] rank = NondominatedRanks.of(scores);
        int fronts = Arrays.stream(rank).max().orElse(-1) + 1;
        int[] size = new int[fronts];
        for (int ofIndividual : rank) {
            size[ofIndividual]++;
        }
        int[][] members = new int[fronts][];
        Arrays.setAll(members, front -> new int[size[front]]);
        int[] filled = new int[fronts];
        for (int individual : order) {
            int front = rank[individual];
            members[front][filled[front]++] = individual;
        }
        return new NondominatedSorting(order, Arrays.asList(members), rank, crowding);
    }

    /** Refuses score vectors of different lengths, and scores that are not finite. */
    static void requireComparable(double[][] scores) {
        for (int i = 0; i < scores.length; i++) {
            if (scores[i].length != scores[0].length) {
                throw new IllegalArgumentException("individual " + i + " has " + scores[i].length
                        + " objectives, but individual 0 has " + scores[0].length);
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
     * The individual at a position of the order in which the crowding distance sorted the population last. Tournaments
     * draw positions of this order. It decides which individual a random number selects, so a run can only equal one of
     * the original with this order.
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

    /** The fronts themselves, not copies; selection does not change them. */
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
