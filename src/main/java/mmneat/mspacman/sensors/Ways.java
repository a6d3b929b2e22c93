package mmneat.mspacman.sensors;

import static mmneat.mspacman.sensors.CorridorPositions.NONE;
import static mmneat.mspacman.sensors.CorridorPositions.opposite;

import pacman.game.internal.MazeGraph;

/**
 * How somebody on the way goes on: along which corridor, and what follows at its end.
 *
 * <p>Source: docs/specification/simulator.md, sections 4.3 and 4.4.
 */
final class Ways {

    /*
     * Whoever is on the way somewhere walks its corridor up to the next junction; there, the rest depends only on the junction
     * and the move by which it was entered.
     *
     *   way   (one long) the corridor with the position it starts from, the steps to the junction at its end, and the row
     *         for what follows. Ways exist for every node and direction, and for every node and last move.
     *   row   number of a junction and arriving move (or none), about 160 in a maze.
     */

    /** A last move that is none, for whoever has not moved yet. */
    static final int NEUTRAL = 4;

    private static final int STEPS_SHIFT = 16;
    private static final int CORRIDOR_SHIFT = 28;
    private static final int START_SHIFT = 40;
    private static final int FIELD_MASK = 0xFFF;
    private static final long BACKWARD = 1L << 52;
    private static final int NO_CORRIDOR = FIELD_MASK;

    private final MazeGraph graph;
    private final CorridorPositions corridors;
    private final int nodes;

    /** Corridor and position of each node, packed as in a way; junctions have corridor 0xFFE, which no way has. */
    private final int[] places;

    /** Way of going on from node v in direction d, at index 4 v + d. */
    private final long[] leaving;

    /** Way of going on from node v after last move m (4 for none), at index 5 v + m. */
    private final long[] continuing;

    /** Row of junction number j entered by move m (4 for none) at index 5 j + m. */
    private final int[] rowOf;

    /** Junction node of each row, and the move by which it was entered. */
    private final int[] rowJunction;

    private final int[] rowArrival;

    Ways(MazeGraph graph) {
        this.graph = graph;
        corridors = new CorridorPositions(graph);
        nodes = graph.nodeCount();
        int junctions = graph.junctionCount();
        rowOf = new int[5 * junctions];
        int count = 0;
        for (int j = 0; j < junctions; j++) {
            int neutral = count++;
            for (int m = 0; m < 4; m++) {
                // A move by which the junction cannot have been entered forbids nothing, like no move.
                rowOf[5 * j + m] = graph.isOpen(graph.junctionNode(j), opposite(m)) ? count++ : neutral;
            }
            rowOf[5 * j + NEUTRAL] = neutral;
        }
        rowJunction = new int[count];
        rowArrival = new int[count];
        for (int j = 0; j < junctions; j++) {
            for (int m = NEUTRAL; m >= 0; m--) {
                int row = rowOf[5 * j + m];
                rowJunction[row] = graph.junctionNode(j);
                if (m == NEUTRAL || row != rowOf[5 * j + NEUTRAL]) {
                    rowArrival[row] = m;
                }
            }
        }
        places = new int[nodes];
        for (int v = 0; v < nodes; v++) {
            places[v] = corridors.corridorOf(v) == NONE
                    ? (NO_CORRIDOR - 1) << 16
                    : corridors.corridorOf(v) << 16 | corridors.positionOf(v);
        }
        leaving = waysOut();
        continuing = waysOn();
    }

    private long[] waysOut() {
        long[] ways = new long[4 * nodes];
        for (int v = 0; v < nodes; v++) {
            for (int d = 0; d < 4; d++) {
                if (graph.isOpen(v, d)) {
                    ways[4 * v + d] = wayOut(v, d);
                }
            }
        }
        return ways;
    }

    private long wayOut(int from, int direction) {
        int first = graph.neighbour(from, direction);
        int corridor = NO_CORRIDOR;
        int start = 0;
        boolean backward = false;
        if (!graph.isJunction(from)) {
            corridor = corridors.corridorOf(from);
            start = corridors.positionOf(from);
            backward = leadsBackward(from, direction);
        } else if (!graph.isJunction(first)) {
            corridor = corridors.corridorOf(first);
            backward = leadsBackward(first, CorridorPositions.onward(graph, first, direction));
            start = backward ? corridors.length(corridor) : -1;
        }
        int move = direction;
        int node = first;
        int steps = 1;
        while (!graph.isJunction(node)) {
            move = CorridorPositions.onward(graph, node, move);
            node = graph.neighbour(node, move);
            steps++;
        }
        return pack(rowOf[5 * graph.junctionNumber(node) + move], steps, corridor, start, backward);
    }

    /** Whether a direction leads down in the positions of a node's corridor. */
    private boolean leadsBackward(int node, int direction) {
        int corridor = corridors.corridorOf(node);
        int position = corridors.positionOf(node);
        if (corridors.length(corridor) == 1) {
            // Nothing in the corridor says which way positions run: the later direction leads up.
            return 1 << direction + 1 < graph.openDirections(node);
        }
        int next = graph.neighbour(node, direction);
        return graph.isJunction(next) ? position == 0 : corridors.positionOf(next) < position;
    }

    private long[] waysOn() {
        long[] ways = new long[5 * nodes];
        for (int v = 0; v < nodes; v++) {
            for (int m = 0; m <= NEUTRAL; m++) {
                if (graph.isJunction(v)) {
                    ways[5 * v + m] = pack(rowOf[5 * graph.junctionNumber(v) + m], 0, NO_CORRIDOR, 0, false);
                } else if (corridors.corridorOf(v) != NONE) {
                    ways[5 * v + m] = wayOn(v, m);
                }
            }
        }
        return ways;
    }

    /** The way that does not turn back; of two such ways the shorter one to a junction, the first on ties. */
    private long wayOn(int node, int lastMove) {
        long best = 0;
        for (int d = 0; d < 4; d++) {
            if (graph.isOpen(node, d) && (lastMove == NEUTRAL || d != opposite(lastMove))) {
                long way = leaving[4 * node + d];
                if (best == 0 || steps(way) < steps(best)) {
                    best = way;
                }
            }
        }
        return best;
    }

    private static long pack(int row, int steps, int corridor, int start, boolean backward) {
        return row
                | (long) steps << STEPS_SHIFT
                | (long) corridor << CORRIDOR_SHIFT
                | (long) (start + 1) << START_SHIFT
                | (backward ? BACKWARD : 0);
    }

    /** Row of what follows at the end of a way. */
    static int row(long way) {
        return (int) way & 0xFFFF;
    }

    /** Steps to the junction at the end of a way's corridor. */
    static int steps(long way) {
        return (int) (way >> STEPS_SHIFT) & FIELD_MASK;
    }

    private static int corridor(long way) {
        return (int) (way >> CORRIDOR_SHIFT) & FIELD_MASK;
    }

    private static int start(long way) {
        return ((int) (way >> START_SHIFT) & FIELD_MASK) - 1;
    }

    /** 1 if a way goes up in the positions of its corridor, -1 if down. */
    private static int sign(long way) {
        return (way & BACKWARD) == 0 ? 1 : -1;
    }

    /** How somebody leaves a node in an open direction. */
    long leaving(int node, int direction) {
        return leaving[4 * node + direction];
    }

    /** How somebody outside the lair goes on who may not turn back after a last move (4 for none). */
    long continuing(int node, int lastMove) {
        return continuing[5 * node + lastMove];
    }

    /** The junction at the end of a way's corridor; where it starts if that is a junction and the way has no corridor yet. */
    int junction(long way) {
        return rowJunction[row(way)];
    }

    /** Number of rows: of different junctions with arriving moves. */
    int rowCount() {
        return rowJunction.length;
    }

    int junctionOfRow(int row) {
        return rowJunction[row];
    }

    /** Whether two ways go along the same corridor in the same sense. */
    static boolean isSameCourse(long way, long other) {
        return ((way ^ other) & (BACKWARD | (long) FIELD_MASK << CORRIDOR_SHIFT)) == 0;
    }

    /** The move by which a row's junction was entered, or {@link #NEUTRAL}. */
    int arrivalOfRow(int row) {
        return rowArrival[row];
    }

    /**
     * Positions that a target lies ahead in the corridor of a way: 0 if it is where the way starts.
     *
     * @return a number below 0 if the target is not in that corridor or lies behind
     */
    int ahead(long way, int target) {
        return aheadOfPlace(way, places[target]);
    }

    /** A node's corridor and position, for {@link #aheadOfPlace}. */
    int place(int node) {
        return places[node];
    }

    /** {@link #ahead} for a target whose place is known. */
    static int aheadOfPlace(long way, int place) {
        return place >> 16 == corridor(way) ? ((place & 0xFFFF) - start(way)) * sign(way) : -1;
    }

    /** The node so many steps along a way, before its junction. */
    int corridorNode(long way, int step) {
        return corridors.node(corridor(way), start(way) + step * sign(way));
    }
}
