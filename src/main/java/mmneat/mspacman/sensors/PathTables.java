package mmneat.mspacman.sensors;

import static mmneat.mspacman.sensors.CorridorPositions.NONE;
import static mmneat.mspacman.sensors.CorridorPositions.opposite;

import java.util.Arrays;
import pacman.game.internal.MazeGraph;
import pacman.game.internal.MazeTables;

/**
 * Lengths and nodes of the simulator's paths in one maze, looked up instead of searched.
 *
 * <p>A path lists the nodes after the start, the target last; its length is its number of steps. The simulator's paths are
 * not exact shortest paths; these are the same, tie for tie.
 *
 * <p>Source: spec/simulator.md, sections 4.3 and 4.4; spec/mspacman-task.md, section 4.3.
 */
final class PathTables {

    /*
     * Whoever is on the way somewhere walks its corridor up to the next junction; there, the rest depends only on the junction
     * and the move by which it was entered. So two things are kept:
     *
     *   way   (one long) how somebody goes on: the corridor with the position it starts from, the steps to the junction at its
     *         end, and the row for what follows. Ways exist for every node and direction, and for every node and last move.
     *   row   per junction and arriving move (or none): for every target the length of the path and which of the target's
     *         neighbours lie on it. About 160 rows of 1300 chars, 0.4 MB a maze, instead of 13 MB for all pairs.
     *
     * A target in the corridor ahead is its distance in positions; any other is the steps to the junction plus the row's entry.
     */

    /** A last move that is none, for whoever has not moved yet. */
    static final int NEUTRAL = 4;

    /** A path passes every node at most so often: leg, path between junctions, leg. */
    static final int LONGEST = 3;

    private static final int LENGTH_BITS = 11;
    private static final int LENGTH_MASK = (1 << LENGTH_BITS) - 1;

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

    /** Whether a neighbour of a node is a junction. */
    private final boolean[] besideJunction;

    /** Way of going on from node v in direction d, at index 4 v + d. */
    private final long[] leaving;

    /** Way of going on from node v after last move m (4 for none), at index 5 v + m. */
    private final long[] continuing;

    /** Row of junction number j entered by move m (4 for none) at index 5 j + m. */
    private final int[] rowOf;

    /** Junction node of each row, and the move by which it was entered. */
    private final int[] rowJunction;

    private final int[] rowArrival;

    /** Length and neighbours of the path from row r's junction to node v, at index nodes r + v. */
    private final char[] rows;

    /** Path from a row's junction to each other junction, by junction number. */
    private final int[][][] junctionPaths;

    /** Length of the undirected path between junctions, by junction numbers. */
    private final int[][] undirected;

    PathTables(MazeTables maze) {
        graph = maze.graph();
        corridors = new CorridorPositions(graph);
        nodes = graph.nodeCount();
        int junctions = graph.junctionCount();
        rowOf = new int[5 * junctions];
        int count = 0;
        for (int j = 0; j < junctions; j++) {
            int neutral = count++;
            for (int m = 0; m < 4; m++) {
                // A move by which the junction cannot have been entered forbids nothing, like no move.
                rowOf[5 * j + m] = isOpen(graph.junctionNode(j), opposite(m)) ? count++ : neutral;
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
        besideJunction = new boolean[nodes];
        for (int j = 0; j < junctions; j++) {
            for (int d = 0; d < 4; d++) {
                if (isOpen(graph.junctionNode(j), d)) {
                    besideJunction[graph.neighbour(graph.junctionNode(j), d)] = true;
                }
            }
        }
        leaving = waysOut();
        continuing = waysOn();
        junctionPaths = new int[count][junctions][];
        undirected = new int[junctions][junctions];
        for (int row = 0; row < count; row++) {
            for (int k = 0; k < junctions; k++) {
                junctionPaths[row][k] = rowJunction[row] == graph.junctionNode(k)
                        ? new int[0]
                        : maze.paths().directedPath(rowJunction[row], graph.junctionNode(k), rowArrival[row]);
                if (rowArrival[row] == NEUTRAL) {
                    undirected[graph.junctionNumber(rowJunction[row])][k] = junctionPaths[row][k].length;
                }
            }
        }
        rows = new char[count * nodes];
        fillRows();
    }

    private boolean isOpen(int node, int direction) {
        return graph.neighbour(node, direction) != NONE;
    }

    // ---- Ways ----

    private long[] waysOut() {
        long[] ways = new long[4 * nodes];
        for (int v = 0; v < nodes; v++) {
            for (int d = 0; d < 4; d++) {
                if (isOpen(v, d)) {
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
            return 1 << direction + 1 < openDirections(node);
        }
        int next = graph.neighbour(node, direction);
        return graph.isJunction(next) ? position == 0 : corridors.positionOf(next) < position;
    }

    /** Open directions of a node, as bits. */
    private int openDirections(int node) {
        int bits = 0;
        for (int d = 0; d < 4; d++) {
            bits |= isOpen(node, d) ? 1 << d : 0;
        }
        return bits;
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
            if (isOpen(node, d) && (lastMove == NEUTRAL || d != opposite(lastMove))) {
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

    private static int row(long way) {
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

    int rowOf(long way) {
        return row(way);
    }

    int junctionOfRow(int row) {
        return rowJunction[row];
    }

    /** Whether two ways go along the same corridor in the same sense. */
    static boolean isSameCourse(long way, long other) {
        return ((way ^ other) & (BACKWARD | (long) FIELD_MASK << CORRIDOR_SHIFT)) == 0;
    }

    // ---- Lengths ----

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

    /**
     * Length of the path along a way to a target.
     *
     * @param least 0 if a target at the way's start is reached by no step, 1 if only by a way around
     */
    int length(long way, int least, int target) {
        int ahead = ahead(way, target);
        return ahead >= least ? ahead : lengthBeyond(way, target);
    }

    /** Length of the path along a way to a target that is not in the corridor ahead. */
    int lengthBeyond(long way, int target) {
        return steps(way) + (rows[row(way) * nodes + target] & LENGTH_MASK);
    }

    /** Length of the path from a row's junction to a target. */
    int rowLength(int row, int target) {
        return rows[row * nodes + target] & LENGTH_MASK;
    }

    /** Length of the simulator's undirected path, where neither end is the lair. */
    int undirectedLength(int from, int to) {
        if (from == to) {
            return 0;
        }
        if (graph.isJunction(from)) {
            return undirectedFromJunction(from, to);
        }
        for (int d = 0; d < 4; d++) {
            if (isOpen(from, d)) {
                int along = alongCorridor(leaving(from, d), to);
                if (along > 0) {
                    return along;
                }
            }
        }
        int shortest = Integer.MAX_VALUE;
        for (int d = 0; d < 4; d++) {
            if (isOpen(from, d)) {
                long leg = leaving(from, d);
                shortest = Math.min(shortest, steps(leg) + undirectedFromJunction(junction(leg), to));
            }
        }
        return shortest;
    }

    /** Steps to a target in the corridor of a way or to the junction at its end; below 0 if it is elsewhere. */
    private int alongCorridor(long way, int target) {
        return target == junction(way) ? steps(way) : ahead(way, target);
    }

    private int undirectedFromJunction(int junction, int to) {
        int[] lengths = undirected[graph.junctionNumber(junction)];
        if (graph.isJunction(to)) {
            return lengths[graph.junctionNumber(to)];
        }
        int shortest = Integer.MAX_VALUE;
        for (int d = 0; d < 4; d++) {
            if (isOpen(to, d)) {
                long leg = leaving(to, d);
                shortest = Math.min(shortest, lengths[graph.junctionNumber(junction(leg))] + steps(leg));
            }
        }
        return shortest;
    }

    // ---- What lies on a path ----

    /**
     * Length of the path along a way to a target, and which neighbours of the target it enters: {@link #lengthOf} and
     * {@link #neighboursOf} take the answer apart.
     *
     * @param way of somebody who reaches a target at its start by no step
     */
    int approach(long way, int target) {
        int ahead = ahead(way, target);
        if (ahead >= 0) {
            return ahead < 2 ? ahead : ahead | neighbourBit(target, corridorNode(way, ahead - 1)) << LENGTH_BITS;
        }
        int steps = steps(way);
        int entry = rows[row(way) * nodes + target];
        int junction = junction(way);
        if (target == junction) {
            return steps < 2 ? steps : steps | neighbourBit(target, corridorNode(way, steps - 1)) << LENGTH_BITS;
        }
        return steps == 0 || !besideJunction[target]
                ? entry + steps
                : entry + steps | neighbourBit(target, junction) << LENGTH_BITS;
    }

    /** The length in an answer of {@link #approach}. */
    static int lengthOf(int approach) {
        return approach & LENGTH_MASK;
    }

    /** The neighbours in an answer of {@link #approach}: bits 0 to 3 for the directions from the target. */
    static int neighboursOf(int approach) {
        return approach >> LENGTH_BITS;
    }

    private int neighbourBit(int node, int neighbour) {
        int bits = 0;
        for (int d = 0; d < 4; d++) {
            if (graph.neighbour(node, d) == neighbour) {
                bits |= 1 << d;
            }
        }
        return bits;
    }

    /** The node so many steps along a way, before its junction. */
    int corridorNode(long way, int step) {
        return corridors.node(corridor(way), start(way) + step * sign(way));
    }

    /**
     * Writes the path along a way to a target.
     *
     * @param least as in {@link #length}
     * @param path receives the nodes after the start
     * @return the length
     */
    int path(long way, int least, int target, int[] path) {
        int ahead = ahead(way, target);
        boolean inCorridor = ahead >= least;
        int steps = inCorridor ? ahead : steps(way);
        int count = 0;
        while (count < steps) {
            count++;
            path[count - 1] = count == steps && !inCorridor ? junction(way) : corridorNode(way, count);
        }
        return inCorridor ? count : rowPath(row(way), target, path, count);
    }

    /**
     * Writes the path from a row's junction to a target behind what is already written.
     *
     * @param count nodes already written
     * @return nodes written in all
     */
    int rowPath(int row, int target, int[] path, int count) {
        if (target == rowJunction[row]) {
            return count;
        }
        int last = lastLeg(row, target);
        int end = count;
        if (last == NONE || junction(leaving(target, last)) != rowJunction[row]) {
            int[] between =
                    junctionPaths[row][graph.junctionNumber(last == NONE ? target : junction(leaving(target, last)))];
            System.arraycopy(between, 0, path, count, between.length);
            end += between.length;
        }
        if (last != NONE) {
            long leg = leaving(target, last);
            for (int step = steps(leg) - 1; step >= 0; step--) {
                path[end++] = step == 0 ? target : corridorNode(leg, step);
            }
        }
        return end;
    }

    // ---- Filling the rows ----

    private void fillRows() {
        long[] onPath = new long[(nodes + 63) / 64];
        for (int row = 0; row < rowJunction.length; row++) {
            for (int k = 0; k < graph.junctionCount(); k++) {
                int[] between = junctionPaths[row][k];
                Arrays.fill(onPath, 0);
                for (int node : between) {
                    onPath[node >> 6] |= 1L << node;
                }
                if (graph.junctionNode(k) != rowJunction[row]) {
                    fillEntry(row, graph.junctionNode(k), NONE, between.length, onPath);
                }
                fillCorridorsAt(row, graph.junctionNode(k), between.length, onPath);
            }
        }
    }

    /** The entries of those targets in the corridors at a junction that are reached through this junction. */
    private void fillCorridorsAt(int row, int junction, int length, long[] onPath) {
        for (int d = 0; d < 4; d++) {
            int node = graph.neighbour(junction, d);
            int move = d;
            while (node != NONE && !graph.isJunction(node)) {
                int leg = opposite(move);
                if (lastLeg(row, node) == leg) {
                    fillEntry(row, node, leg, length + steps(leaving(node, leg)), onPath);
                }
                move = CorridorPositions.onward(graph, node, move);
                node = graph.neighbour(node, move);
            }
        }
    }

    private void fillEntry(int row, int target, int leg, int length, long[] onPath) {
        if (length > LENGTH_MASK) {
            throw new IllegalArgumentException("maze: a path of " + length + " steps is longer than " + LENGTH_MASK);
        }
        int passed = 0;
        for (int d = 0; d < 4; d++) {
            int neighbour = graph.neighbour(target, d);
            boolean onLastLeg = d == leg && steps(leaving(target, leg)) > 1;
            if (neighbour != NONE && (onLastLeg || (onPath[neighbour >> 6] >>> neighbour & 1) != 0)) {
                passed |= 1 << d;
            }
        }
        rows[row * nodes + target] = (char) (length | passed << LENGTH_BITS);
    }

    /**
     * The direction in which a target's corridor is left backwards along the path from a row's junction, or {@link
     * CorridorPositions#NONE} if the target is a junction. The simulator's rule: a corridor that starts at the row's junction itself,
     * if it may be entered, replaces whatever was found before, longer or not.
     */
    private int lastLeg(int row, int target) {
        if (graph.isJunction(target)) {
            return NONE;
        }
        int chosen = NONE;
        int shortest = Integer.MAX_VALUE;
        for (int d = 0; d < 4; d++) {
            if (isOpen(target, d)) {
                long leg = leaving(target, d);
                if (junction(leg) == rowJunction[row]) {
                    int entry = opposite(arrivalOf(leg));
                    if (rowArrival[row] == NEUTRAL || entry != opposite(rowArrival[row])) {
                        shortest = steps(leg);
                        chosen = d;
                    }
                } else {
                    int length = junctionPaths[row][graph.junctionNumber(junction(leg))].length + steps(leg);
                    if (length < shortest) {
                        shortest = length;
                        chosen = d;
                    }
                }
            }
        }
        return chosen;
    }

    private int arrivalOf(long way) {
        return rowArrival[row(way)];
    }
}
