package mmneat.nsga2;

import mmneat.random.ResumableRandom;

/**
 * Binary tournaments with replacement: two individuals are drawn, and the better one becomes a parent.
 *
 * <p>Source: docs/specification/evolution.md, section 2.4.
 */
final class Tournament {

    private final double[][] scores;
    private final NondominatedSorting sorting;
    private final boolean byDominance;

    /** Tournaments that compare by rank, then by crowding distance. */
    static Tournament byCrowding(double[][] scores, NondominatedSorting sorting) {
        return new Tournament(scores, sorting, false);
    }

    /** Tournaments that ask only whether the first dominates the second. */
    static Tournament byDominance(double[][] scores, NondominatedSorting sorting) {
        return new Tournament(scores, sorting, true);
    }

    private Tournament(double[][] scores, NondominatedSorting sorting, boolean byDominance) {
        this.scores = scores;
        this.sorting = sorting;
        this.byDominance = byDominance;
    }

    /** Draws two individuals, which may be the same, and returns the better one. */
    int winner(ResumableRandom random) {
        int first = sorting.individualAt(random.nextInt(sorting.size()));
        int second = sorting.individualAt(random.nextInt(sorting.size()));
        return firstWins(first, second) ? first : second;
    }

    private boolean firstWins(int first, int second) {
        if (byDominance) {
            return Dominance.dominatesUnchecked(scores[first], scores[second]);
        }
        if (sorting.rank(first) != sorting.rank(second)) {
            return sorting.rank(first) < sorting.rank(second);
        }
        return sorting.crowding(first) >= sorting.crowding(second);
    }
}
