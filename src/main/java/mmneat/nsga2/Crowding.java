package mmneat.nsga2;

import java.util.Arrays;
import java.util.List;

/**
 * The set of individuals among which the crowding distance is measured: the whole population as in MM-NEAT, or each
 * front as in the published NSGA-II.
 */
public enum Crowding {

    /**
     * The whole population, all fronts together, normalised by the range of each objective, as in the original. Source:
     * docs/specification/evolution.md, section 2.2.
     */
    WHOLE_POPULATION {
        @Override
        NondominatedSorting sort(double[][] scores) {
            double[] distance = new double[scores.length];
            int[] order = addDistances(scores, ScoreOrder.identity(scores.length), distance);
            // All later steps, including the breaking of ties, use the order in which the last objective was sorted.
            return NondominatedSorting.of(scores, order, distance);
        }
    },

    /**
     * Each front separately, normalised by the front's range of each objective, as published: Deb et al. 2002, section
     * III-B.
     */
    PER_FRONT {
        @Override
        NondominatedSorting sort(double[][] scores) {
            double[] distance = new double[scores.length];
            NondominatedSorting sorting = NondominatedSorting.of(scores, ScoreOrder.identity(scores.length), distance);
            List<int[]> fronts = sorting.sharedFronts();
            fronts.forEach(front -> addDistances(scores, front, distance));
            return sorting;
        }
    };

    /** Fronts and crowding distances of {@code scores[individual][objective]}. */
    abstract NondominatedSorting sort(double[][] scores);

    /**
     * Adds to {@code distance[i]}, for each of {@code members} and in each objective, the gap between its two
     * neighbours as a share of the range. Exactly one individual at either end of each objective is infinitely far from
     * the others, even among duplicates.
     *
     * @return the members sorted by the last objective, ties by the one before it, and so on, then in the given order
     */
    private static int[] addDistances(double[][] scores, int[] members, double[] distance) {
        int[] order = members;
        int objectives = members.length == 0 ? 0 : scores[members[0]].length;
        for (int j = 0; j < objectives; j++) {
            int objective = j;
            order = ScoreOrder.ascending(order, i -> scores[i][objective]);
            int first = order[0];
            int last = order[order.length - 1];
            distance[first] = Double.POSITIVE_INFINITY;
            distance[last] = Double.POSITIVE_INFINITY;
            double unit = unit(scores[first][objective], scores[last][objective]);
            double range = unit * scores[last][objective] - unit * scores[first][objective];
            if (range > 0) {
                for (int k = 1; k < order.length - 1; k++) {
                    double gap = unit * scores[order[k + 1]][objective] - unit * scores[order[k - 1]][objective];
                    distance[order[k]] += gap / range;
                }
            }
        }
        return order == members ? Arrays.copyOf(members, members.length) : order;
    }

    /** The factor for scores: 1, or 1/2 if their difference would overflow. */
    private static double unit(double least, double greatest) {
        return Double.isInfinite(greatest - least) ? 0.5 : 1;
    }
}
