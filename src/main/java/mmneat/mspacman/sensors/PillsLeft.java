package mmneat.mspacman.sensors;

import java.util.Arrays;
import pacman.maze.PillTables;
import pacman.maze.Routes;

/** The active pills of one kind, and the nearest one in each direction from Ms.&nbsp;Pac-Man. */
final class PillsLeft {

    /*
     * The nearest pill in a direction stays the same while Ms. Pac-Man goes along a corridor and that pill is active.
     * So its distance from the junction ahead is kept. A pill on her own node does not disturb this. If her next step
     * goes on along the corridor in the direction, the corridor is straight there, and the pill is at distance 0.
     * Pills come back only when a level starts.
     */

    private static final long UNKNOWN = -1;

    @SuppressWarnings("NullAway.Init")
    private PillTables tables;

    private long[] bits = new long[0];
    private int count;

    /** In each row's order of pills the first that may be active. */
    private int[] firstRank = new int[0];

    /** Per direction, the route for which the nearest pill is known, or {@link #UNKNOWN}. */
    private final long[] knownRoute = new long[4];

    /** Per direction, that pill, and its steps less those to the junction ahead. */
    private final int[] knownPill = new int[4];

    private final int[] knownSteps = new int[4];

    /** Sets the maze. Bits are given afterwards. */
    void enter(PillTables ofMaze, int rows, int words) {
        tables = ofMaze;
        bits = new long[words];
        count = 0;
        firstRank = new int[rows];
        Arrays.fill(knownRoute, UNKNOWN);
    }

    /**
     * Sets one word of the bits of active pills.
     *
     * @return whether this changes the word
     */
    boolean set(int word, long active) {
        long before = bits[word];
        if (active == before) {
            return false;
        }
        if ((active & ~before) != 0) {
            Arrays.fill(firstRank, 0);
            Arrays.fill(knownRoute, UNKNOWN);
        }
        count += Long.bitCount(active) - Long.bitCount(before);
        bits[word] = active;
        return true;
    }

    /** Bits of the active pills. */
    long[] bits() {
        return bits;
    }

    /** Number of active pills. */
    int count() {
        return count;
    }

    /**
     * Steps from a node to the nearest active pill.
     *
     * @param route by which the direction leaves the node
     * @param least 0 if a pill on the node itself is reached by no step, 1 if only by a way around
     * @return -1 if no pill is left
     */
    int nearest(int node, int direction, long route, int least) {
        if (count == 0) {
            return -1;
        }
        if (least == 0 && tables.isActiveAt(node, bits)) {
            return 0;
        }
        if (!Routes.isStepAlong(knownRoute[direction], route) || !PillTables.isActive(knownPill[direction], bits)) {
            find(node, direction, route);
        }
        knownRoute[direction] = route;
        return Routes.steps(route) + knownSteps[direction];
    }

    private void find(int node, int direction, long route) {
        int row = Routes.row(route);
        int found = tables.firstAhead(node, direction, bits);
        int steps = PillTables.stepsOf(found) - Routes.steps(route);
        if (found == 0) {
            firstRank[row] = tables.firstActive(row, firstRank[row], bits);
            found = tables.ranked(row, firstRank[row]);
            steps = PillTables.stepsOf(found);
        }
        knownPill[direction] = PillTables.pillOf(found);
        knownSteps[direction] = steps;
    }
}
