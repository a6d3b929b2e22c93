package pacman.maze;

/**
 * The precomputed continuations of paths that never turn back: corridor, length, and what follows at the end junction.
 *
 * <p>What follows at a junction depends only on the junction and on the move that entered it. A <em>row</em> is the
 * number of such a pair, from 0 to {@link #rowCount} - 1; the move may be none. Other tables have one entry per row. A
 * <em>route</em> is one long for a walker's way to the next junction: the corridor, the walker's position in it, the
 * steps to the junction, and the row there. A walker that stands on a junction without having chosen a direction has a
 * route of 0 steps without a corridor. A <em>segment</em> is the number of a corridor, a junction, or the lair. A
 * <em>place</em> is a node as one int: its segment in the upper 16 bits and its position in the segment in the lower.
 *
 * <p>Source: docs/specification/simulator.md, sections 4.3 and 4.4.
 */
public final class Routes {

    /*
     * A path that never turns back follows its corridor to the next junction. What comes after depends only on that
     * junction and on the move that entered it. So only (junction, entering move) pairs need a table row, about 160 per
     * maze:
     *
     *   route  one long: corridor, start position in it, steps to the junction at its end, row to continue with. Routes
     *          exist for every node and direction, and for every node and last move.
     *   row    number of a (junction, entering move) pair; the move may be none
     */

    /** The last move of a walker that has not moved yet. */
    public static final int NEUTRAL = 4;

    private static final int STEPS_SHIFT = 16;
    private static final int CORRIDOR_SHIFT = 28;
    private static final int START_SHIFT = 40;
    private static final int FIELD_MASK = 0xFFF;
    private static final long BACKWARD = 1L << 52;
    private static final int NO_CORRIDOR = FIELD_MASK;
    private static final int ROW_MASK = 0xFFFF;

    /** The bits in which routes along the same corridor in the same sense are equal. */
    private static final long COURSE = BACKWARD | (long) FIELD_MASK << CORRIDOR_SHIFT;

    private final MazeGraph graph;
    private final Corridors corridors;
    private final int nodes;

    /**
     * Segment of each node in the upper half: its corridor, or a number of its own for a junction; its position in the
     * lower.
     */
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

    Routes(MazeGraph graph, Corridors corridors) {
        this.graph = graph;
        this.corridors = corridors;
        nodes = graph.nodeCount();
        int junctions = graph.junctionCount();
        rowOf = new int[5 * junctions];
        int count = 0;
        for (int j = 0; j < junctions; j++) {
            int neutral = count++;
            for (int m = 0; m < 4; m++) {
                // A move by which the junction cannot have been entered forbids nothing, like no move.
                rowOf[5 * j + m] = graph.isOpen(graph.junctionNode(j), MazeGraph.opposite(m)) ? count++ : neutral;
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
            // Junctions and, as the last one, the lair are segments of their own.
            places[v] = corridors.corridor(v) == MazeGraph.NONE
                    ? corridors.count() + (v == graph.lair() ? junctions : graph.junctionNumber(v)) << 16
                    : corridors.corridor(v) << 16 | corridors.position(v);
        }
        leaving = routesOut();
        continuing = routesOn();
    }

    private long[] routesOut() {
        long[] routes = new long[4 * nodes];
        for (int v = 0; v < nodes; v++) {
            for (int d = 0; d < 4; d++) {
                if (graph.isOpen(v, d)) {
                    routes[4 * v + d] = routeOut(v, d);
                }
            }
        }
        return routes;
    }

    private long routeOut(int from, int direction) {
        if (!graph.isJunction(from)) {
            return routeAlong(from, corridors.legTowards(from, direction), 0);
        }
        int first = graph.neighbour(from, direction);
        return graph.isJunction(first)
                ? pack(rowOf[5 * graph.junctionNumber(first) + direction], 1, NO_CORRIDOR, 0, false)
                : routeAlong(first, corridors.legTowards(first, graph.onlyWayOn(first, direction)), 1);
    }

    /** The route along a leg that starts so many steps before the leg's node. */
    private long routeAlong(int node, int leg, int before) {
        boolean ascending = corridors.isAscending(node, leg);
        return pack(
                rowOf[5 * graph.junctionNumber(corridors.junction(node, leg)) + corridors.lastMove(node, leg)],
                before + corridors.length(node, leg),
                corridors.corridor(node),
                corridors.position(node) + (ascending ? -before : before),
                !ascending);
    }

    private long[] routesOn() {
        long[] routes = new long[5 * nodes];
        for (int v = 0; v < nodes; v++) {
            for (int m = 0; m <= NEUTRAL; m++) {
                if (graph.isJunction(v)) {
                    routes[5 * v + m] = pack(rowOf[5 * graph.junctionNumber(v) + m], 0, NO_CORRIDOR, 0, false);
                } else if (corridors.corridor(v) != MazeGraph.NONE) {
                    routes[5 * v + m] = routeOn(v, m);
                }
            }
        }
        return routes;
    }

    /** The route that does not turn back; of two such routes the shorter one to a junction, the first on ties. */
    private long routeOn(int node, int lastMove) {
        long best = 0;
        for (int d = 0; d < 4; d++) {
            if (graph.isOpen(node, d) && (lastMove == NEUTRAL || d != MazeGraph.opposite(lastMove))) {
                long route = leaving[4 * node + d];
                if (best == 0 || steps(route) < steps(best)) {
                    best = route;
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

    /** The row at the end of a route: the number of the pair of the junction there and the move that enters it. */
    public static int row(long route) {
        return (int) route & ROW_MASK;
    }

    /** Steps to the junction at the end of a route's corridor. */
    public static int steps(long route) {
        return (int) (route >> STEPS_SHIFT) & FIELD_MASK;
    }

    private static int corridor(long route) {
        return (int) (route >> CORRIDOR_SHIFT) & FIELD_MASK;
    }

    private static int start(long route) {
        return ((int) (route >> START_SHIFT) & FIELD_MASK) - 1;
    }

    /** 1 if a route goes up in the positions of its corridor, -1 if down. */
    private static int sign(long route) {
        return (route & BACKWARD) == 0 ? 1 : -1;
    }

    /** The route that leaves a node in an open direction. */
    public long leaving(int node, int direction) {
        return leaving[4 * node + direction];
    }

    /**
     * The route that continues from a node outside the lair without turning back. If there are two, because there was
     * no last move or the last move cannot have entered the node, it is the shorter one to a junction.
     *
     * @param lastMove 0 to 3, or 4 for none
     */
    public long continuing(int node, int lastMove) {
        return continuing[5 * node + lastMove];
    }

    /**
     * The junction at the end of a route's corridor. If the route has no corridor, because it starts on a junction and
     * has no direction yet, this is the junction where it starts.
     */
    public int junction(long route) {
        return rowJunction[row(route)];
    }

    /** Number of rows: pairs of a junction and a move that enters it, or no move. */
    public int rowCount() {
        return rowJunction.length;
    }

    /** The junction (node) of a row. */
    public int junctionOfRow(int row) {
        return rowJunction[row];
    }

    /** Whether two routes go along the same corridor in the same direction. */
    public static boolean isSameCourse(long route, long other) {
        return ((route ^ other) & COURSE) == 0;
    }

    /** Whether two routes start at most one step apart and go to the same junction along the same corridor. */
    public static boolean isStepAlong(long route, long other) {
        return ((route ^ other) & (COURSE | ROW_MASK)) == 0 && Math.abs(steps(route) - steps(other)) <= 1;
    }

    /** The move by which a row's junction was entered, or {@link #NEUTRAL}. */
    public int arrivalOfRow(int row) {
        return rowArrival[row];
    }

    /**
     * Steps from the start of a route to a target in the corridor of the route.
     *
     * @return 0 if the target is the start; a negative number if it lies behind the start or is not in that corridor
     */
    public int ahead(long route, int target) {
        return aheadOfPlace(route, places[target]);
    }

    /** The place of a node: its segment (corridor, junction or lair) in the upper 16 bits, its position there below. */
    public int place(int node) {
        return places[node];
    }

    /** {@link #ahead} for a target whose place is known. */
    public static int aheadOfPlace(long route, int place) {
        return place >> 16 == corridor(route) ? (position(place) - start(route)) * sign(route) : -1;
    }

    /** The node {@code step} steps along a route; it must lie before the junction at the end. */
    public int corridorNode(long route, int step) {
        return corridors.node(corridor(route), start(route) + step * sign(route));
    }

    /** Returns the position of a place in its corridor. */
    static int position(int place) {
        return place & 0xFFFF;
    }

    /** The segment of a place: the number of its corridor, junction, or the lair. */
    public static int segment(int place) {
        return place >> 16;
    }

    /** Number of corridors and junctions, and one for the lair. */
    public int segmentCount() {
        return corridors.count() + graph.junctionCount() + 1;
    }
}
