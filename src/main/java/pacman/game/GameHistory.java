package pacman.game;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.List;

/**
 * The history of a game for reports: lists on which no rule depends. Copies of a game have no history.
 *
 * <p>Source: docs/specification/simulator.md, sections 2.4, 2.5 and 8.
 */
final class GameHistory {

    /** Entry of {@link #timesToEatAll} when not all ghosts were eaten. */
    static final int NEVER = Integer.MAX_VALUE;

    /** Total time at which each pill or power pill was eaten. */
    final IntList pillEatTimes = new IntList();
    /** Total time at which each ghost was eaten. */
    final IntList ghostEatTimes = new IntList();
    /** Ghosts eaten after each power pill. */
    final IntList ghostsPerPowerPill = new IntList();
    /** Steps from a power pill until all ghosts were eaten. */
    final IntList timesToEatAll = new IntList();
    /** Score gained in each level that is over. */
    private double[] levelScores = new double[16];

    private int levels;
    private double closedScore;

    void clear() {
        pillEatTimes.clear();
        ghostEatTimes.clear();
        ghostsPerPowerPill.clear();
        timesToEatAll.clear();
        levels = 0;
        closedScore = 0;
    }

    void closeLevel(int score) {
        if (levels == levelScores.length) {
            levelScores = Arrays.copyOf(levelScores, 2 * levels);
        }
        levelScores[levels] = score - closedScore;
        closedScore += levelScores[levels];
        levels++;
    }

    /** Score gained in a level; a call for the first level without an entry closes that level's entry. */
    double levelScore(int level, int score) {
        if (level == levels) {
            closeLevel(score);
        }
        if (level < 0 || level >= levels) {
            throw new IndexOutOfBoundsException(
                    "level scores are known up to level " + (levels - 1) + ", asked for " + level);
        }
        return levelScores[level];
    }

    /** Counts a ghost eaten after the last power pill; {@code isLast}: whether no ghost is edible any more. */
    void ghostEaten(int activeGhosts, boolean isLast, int stepsSincePowerPill) {
        int last = ghostsPerPowerPill.size() - 1;
        if (last < 0) {
            // A restored game has no record of the power pill; the original throws here.
            return;
        }
        ghostsPerPowerPill.set(last, ghostsPerPowerPill.get(last) + 1);
        if (ghostsPerPowerPill.get(last) == activeGhosts) {
            timesToEatAll.add(stepsSincePowerPill);
        } else if (isLast) {
            timesToEatAll.add(NEVER);
        }
    }

    /**
     * Mean number of ghosts eaten per power pill. With {@code withUneaten}, zeros for uneaten power pills are added
     * permanently.
     */
    double meanGhostsPerPowerPill(boolean withUneaten, int powerPills) {
        if (withUneaten) {
            pad(ghostsPerPowerPill, powerPills, 0);
        }
        return ghostsPerPowerPill.mean();
    }

    double meanTimeToEatAll(int powerPills) {
        pad(timesToEatAll, powerPills, NEVER);
        return timesToEatAll.mean();
    }

    private static void pad(IntList list, int size, int value) {
        while (list.size() < size) {
            list.add(value);
        }
    }

    /** A growing list of ints. */
    static final class IntList {

        private int[] values = new int[64];
        private int size;

        void add(int value) {
            if (size == values.length) {
                values = Arrays.copyOf(values, 2 * size);
            }
            values[size++] = value;
        }

        int get(int index) {
            return values[index];
        }

        void set(int index, int value) {
            values[index] = value;
        }

        int size() {
            return size;
        }

        void clear() {
            size = 0;
        }

        /** The mean as the original accumulates it: avg += (x - avg) / (i + 1); 0 for an empty list. */
        double mean() {
            double mean = 0;
            for (int i = 0; i < size; i++) {
                mean += (values[i] - mean) / (i + 1);
            }
            return mean;
        }

        /** Returns a copy of the list. */
        List<Integer> toList() {
            int[] copy = Arrays.copyOf(values, size);
            return new AbstractList<>() {
                @Override
                public Integer get(int index) {
                    return copy[index];
                }

                @Override
                public int size() {
                    return copy.length;
                }
            };
        }
    }
}
