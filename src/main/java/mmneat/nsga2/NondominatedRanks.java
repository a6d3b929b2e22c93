package mmneat.nsga2;

import java.util.Arrays;

/**
 * Ranks of a population by divide and conquer: rank 0 is dominated by no individual, rank r only by individuals of
 * lower rank.
 *
 * <p>O(n log n) for two objectives, O(n log(n)^(m-1)) for m objectives. Scores are replaced by their positions in the
 * sorted order of each objective (0 is the best), so that comparisons are comparisons of small integers.
 *
 * <p>Source: M. T. Jensen, IEEE Transactions on Evolutionary Computation 7 (2003); F.-A. Fortin, S. Grenier and M.
 * Parizeau, GECCO 2013; M. Buzdalov and A. Shalyto, PPSN 2014.
 */
final class NondominatedRanks {

    /** Up to this number of points, comparing all pairs is faster than dividing them. */
    private static final int FEW = 64;

    /** As {@link #FEW}, for the smaller one of two sets. */
    private static final int FEW_PAIRS = 16;

    /** {@code position[objective][point]}: 0 for the best score; equal scores share a position. */
    private final int[][] position;

    /** Lower bound of the rank of each point; at the end its rank. */
    private final int[] rank;

    /**
     * Prefix maxima of ranks over the positions in the second objective (a Fenwick tree), each plus 1; 0 where it is
     * empty. It is empty between two sweeps.
     */
    private final int[] highestRank;

    private NondominatedRanks(int[][] position, int points) {
        this.position = position;
        this.rank = new int[points];
        this.highestRank = new int[points + 1];
    }

    /**
     * Ranks a population.
     *
     * @param scores {@code scores[individual][objective]}, all maximised, finite and of one length
     * @return the rank of each individual, from 0
     */
    static int[] of(double[][] scores) {
        int size = scores.length;
        int objectives = size == 0 ? 0 : scores[0].length;
        if (objectives == 0) {
            return new int[size];
        }
        int[][] position = new int[Math.max(2, objectives)][];
        for (int objective = 0; objective < objectives; objective++) {
            position[objective] = positions(scores, objective);
        }
        if (objectives == 1) {
            position[1] = position[0];
        }
        int[] sorted = lexicographic(position, size);
        int[] distinct = withoutDuplicates(sorted, position);
        NondominatedRanks ranks = new NondominatedRanks(position, size);
        ranks.rankAmong(distinct, position.length - 1);
        ranks.copyToDuplicates(sorted);
        return ranks.rank;
    }

    private static int[] positions(double[][] scores, int objective) {
        double[] values = new double[scores.length];
        // The negative, so that the best comes first. Adding 0 makes the two zeros one.
        Arrays.setAll(values, i -> 0.0 - scores[i][objective]);
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int[] positions = new int[values.length];
        Arrays.setAll(positions, i -> ScoreOrder.firstPosition(sorted, values[i]));
        return positions;
    }

    /** All points, sorted by the first objective, ties by the second, and so on: a counting sort for each objective. */
    private static int[] lexicographic(int[][] position, int size) {
        int[] order = ScoreOrder.identity(size);
        for (int objective = position.length - 1; objective >= 0; objective--) {
            order = ScoreOrder.byPosition(order, position[objective]);
        }
        return order;
    }

    private static int[] withoutDuplicates(int[] sorted, int[][] position) {
        int[] distinct = new int[sorted.length];
        int count = 0;
        for (int i = 0; i < sorted.length; i++) {
            if (i == 0 || !equal(position, sorted[i - 1], sorted[i])) {
                distinct[count++] = sorted[i];
            }
        }
        return Arrays.copyOf(distinct, count);
    }

    private static boolean equal(int[][] position, int a, int b) {
        for (int[] ofObjective : position) {
            if (ofObjective[a] != ofObjective[b]) {
                return false;
            }
        }
        return true;
    }

    private void copyToDuplicates(int[] sorted) {
        for (int i = 1; i < sorted.length; i++) {
            if (equal(position, sorted[i - 1], sorted[i])) {
                rank[sorted[i]] = rank[sorted[i - 1]];
            }
        }
    }

    /**
     * Completes the ranks of {@code points}, which are equal in all objectives after {@code last}. Dominance by other
     * points is already counted.
     *
     * @param points distinct points in lexicographic order
     */
    private void rankAmong(int[] points, int last) {
        if (points.length <= FEW) {
            for (int i = 1; i < points.length; i++) {
                for (int j = 0; j < i; j++) {
                    raise(points[j], points[i], last);
                }
            }
        } else if (last == 1) {
            sweep(points, points);
        } else {
            int[] values = position[last];
            int pivot = median(points, values);
            int[] better = select(points, values, pivot, -1);
            int[] equal = select(points, values, pivot, 0);
            int[] worse = select(points, values, pivot, 1);
            rankAmong(better, last);
            raiseBy(better, equal, last - 1);
            rankAmong(equal, last - 1);
            raiseBy(merge(better, equal), worse, last - 1);
            rankAmong(worse, last);
        }
    }

    /**
     * Raises the ranks of {@code points} above those of the {@code dominators} that dominate them. In all objectives
     * after {@code last} each dominator is at least as good as each point; the ranks of the dominators are complete.
     */
    private void raiseBy(int[] dominators, int[] points, int last) {
        if (dominators.length == 0 || points.length == 0) {
            return;
        }
        if (Math.min(dominators.length, points.length) <= FEW_PAIRS) {
            for (int dominator : dominators) {
                for (int point : points) {
                    raise(dominator, point, last);
                }
            }
            return;
        }
        if (last == 1) {
            sweep(dominators, points);
            return;
        }
        int[] values = position[last];
        if (max(dominators, values) <= min(points, values)) {
            raiseBy(dominators, points, last - 1);
        } else if (min(dominators, values) <= max(points, values)) {
            int pivot = median(merge(dominators, points), values);
            int[] betterDominators = select(dominators, values, pivot, -1);
            int[] equalDominators = select(dominators, values, pivot, 0);
            int[] betterPoints = select(points, values, pivot, -1);
            int[] equalPoints = select(points, values, pivot, 0);
            int[] worsePoints = select(points, values, pivot, 1);
            raiseBy(betterDominators, betterPoints, last);
            raiseBy(betterDominators, equalPoints, last - 1);
            raiseBy(equalDominators, equalPoints, last - 1);
            raiseBy(merge(betterDominators, equalDominators), worsePoints, last - 1);
            raiseBy(select(dominators, values, pivot, 1), worsePoints, last);
        }
    }

    /**
     * Raises the rank of {@code point} if {@code dominator} is at least as good in the objectives 0 to {@code last}.
     */
    private void raise(int dominator, int point, int last) {
        if (rank[point] > rank[dominator]) {
            return;
        }
        for (int objective = 0; objective <= last; objective++) {
            if (position[objective][dominator] > position[objective][point]) {
                return;
            }
        }
        rank[point] = rank[dominator] + 1;
    }

    /*
     * Two objectives: a sweep visits the points in the order of the first objective. The dominators visited before a
     * point are those at least as good in the first objective. The tree returns the highest rank among those that are
     * also at least as good in the second objective.
     */
    private void sweep(int[] dominators, int[] points) {
        boolean isAmong = dominators == points;
        int[] first = position[0];
        int[] second = position[1];
        int passed = 0;
        for (int point : points) {
            while (!isAmong && passed < dominators.length && first[dominators[passed]] <= first[point]) {
                put(second[dominators[passed]], rank[dominators[passed]] + 1);
                passed++;
            }
            rank[point] = Math.max(rank[point], highest(second[point]));
            if (isAmong) {
                put(second[point], rank[point] + 1);
                passed++;
            }
        }
        for (int i = 0; i < passed; i++) {
            for (int node = second[dominators[i]] + 1; node < highestRank.length; node += node & -node) {
                highestRank[node] = 0;
            }
        }
    }

    private void put(int place, int value) {
        for (int node = place + 1; node < highestRank.length && highestRank[node] < value; node += node & -node) {
            highestRank[node] = value;
        }
    }

    private int highest(int place) {
        int highest = 0;
        for (int node = place + 1; node > 0; node -= node & -node) {
            highest = Math.max(highest, highestRank[node]);
        }
        return highest;
    }

    /** The points whose value is below (-1), equal to (0) or above (1) the pivot, in their order. */
    private static int[] select(int[] points, int[] values, int pivot, int sign) {
        int[] selected = new int[points.length];
        int count = 0;
        for (int point : points) {
            if (Integer.signum(values[point] - pivot) == sign) {
                selected[count++] = point;
            }
        }
        return Arrays.copyOf(selected, count);
    }

    /** The points of both sets in lexicographic order. */
    private int[] merge(int[] a, int[] b) {
        int[] merged = new int[a.length + b.length];
        int i = 0;
        int j = 0;
        for (int k = 0; k < merged.length; k++) {
            boolean takesA = j == b.length || i < a.length && isBefore(a[i], b[j]);
            merged[k] = takesA ? a[i++] : b[j++];
        }
        return merged;
    }

    private boolean isBefore(int a, int b) {
        for (int[] ofObjective : position) {
            if (ofObjective[a] != ofObjective[b]) {
                return ofObjective[a] < ofObjective[b];
            }
        }
        return true;
    }

    private static int median(int[] points, int[] values) {
        int[] sorted = new int[points.length];
        Arrays.setAll(sorted, i -> values[points[i]]);
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }

    private static int min(int[] points, int[] values) {
        int min = Integer.MAX_VALUE;
        for (int point : points) {
            min = Math.min(min, values[point]);
        }
        return min;
    }

    private static int max(int[] points, int[] values) {
        int max = Integer.MIN_VALUE;
        for (int point : points) {
            max = Math.max(max, values[point]);
        }
        return max;
    }
}
