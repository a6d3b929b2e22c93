package pacman.maze;

import java.util.Arrays;

/**
 * Lengths and nodes of the simulator's paths in one maze, looked up instead of searched.
 *
 * <p>A path lists the nodes after the start, the target last; its length is its number of steps. The simulator's paths
 * are not exact shortest paths; these are the same, tie for tie.
 *
 * <p>Source: docs/specification/simulator.md, sections 4.3 and 4.4; docs/specification/mspacman-task.md, section 4.3.
 */
public final class PathTables {

    /*
     * A path goes along a route (Routes) to the junction at the end of its corridor; what follows there depends on the
     * route's row alone: for every row and target there are the length of the path and which of the target's neighbours
     * lie on it. About 160 rows of 1300 chars, 0.4 MB a maze, instead of 13 MB for all pairs.
     *
     * A target in the corridor ahead is its distance in positions; any other is the steps to the junction plus the
     * row's entry.
     */

    /** A path passes every node at most so often: leg, path between junctions, leg. */
    public static final int LONGEST = 3;

    private static final int LENGTH_BITS = 11;
    private static final int LENGTH_MASK = (1 << LENGTH_BITS) - 1;

    private static final int STEPS_BITS = 12;
    private static final int STEPS_MASK = (1 << STEPS_BITS) - 1;

    /** More than any length of a path; a length together with it still has its bit. */
    private static final int OWN_JUNCTION = 1 << 14;

    private final MazeGraph graph;
    private final MazePaths simulated;
    private final Routes routes;
    private final int nodes;

    /** Whether a neighbour of a node is a junction. */
    private final boolean[] besideJunction;

    /** Length and neighbours of the path from row r's junction to node v, at index nodes r + v. */
    private final char[] rows;

    /**
     * Length of the path from row r's junction to junction k, by its number, at index junctions r + k; {@link
     * #OWN_JUNCTION} for the row's own: what is beside it can be exceptional. Small enough for the first-level cache,
     * where the rows are not.
     */
    private final char[] toJunctions;

    /** Length of the undirected path between junctions j and k, by their numbers, at index junctions j + k. */
    private final char[] undirected;

    /**
     * Number of the junction at each end of node v's corridor, in the lower {@value #STEPS_BITS} bits the steps to it,
     * and between them a bit for the direction in which it is; from index 2 v on. The direction is left out where paths
     * may enter other neighbours than that.
     */
    private final int[] legs;

    /** The paths of a maze. */
    public PathTables(MazeTables maze, Routes routes) {
        this.routes = routes;
        graph = maze.graph();
        simulated = maze.paths();
        nodes = graph.nodeCount();
        besideJunction = new boolean[nodes];
        for (int j = 0; j < graph.junctionCount(); j++) {
            for (int d = 0; d < 4; d++) {
                if (graph.isOpen(graph.junctionNode(j), d)) {
                    besideJunction[graph.neighbour(graph.junctionNode(j), d)] = true;
                }
            }
        }
        legs = findLegs();
        rows = new char[routes.rowCount() * nodes];
        fillRows();
        int junctions = graph.junctionCount();
        undirected = new char[junctions * junctions];
        toJunctions = new char[routes.rowCount() * junctions];
        for (int row = 0; row < routes.rowCount(); row++) {
            int own = graph.junctionNumber(routes.junctionOfRow(row));
            for (int k = 0; k < junctions; k++) {
                char length = (char) (rows[row * nodes + graph.junctionNode(k)] & LENGTH_MASK);
                toJunctions[row * junctions + k] = k == own ? OWN_JUNCTION : length;
                if (routes.arrivalOfRow(row) == Routes.NEUTRAL) {
                    undirected[own * junctions + k] = length;
                }
            }
        }
        nameNeighbours();
    }

    private void fillRows() {
        int[] path = new int[LONGEST * nodes];
        int[] stamps = new int[nodes];
        int stamp = 0;
        for (int row = 0; row < routes.rowCount(); row++) {
            for (int target = 0; target < graph.lair(); target++) {
                int length = rowPath(row, target, path, 0);
                if (length > LENGTH_MASK) {
                    throw new IllegalArgumentException(
                            "maze " + graph.name() + ": a path of " + length + " steps is longer than " + LENGTH_MASK);
                }
                stamp++;
                for (int i = 0; i < length; i++) {
                    stamps[path[i]] = stamp;
                }
                int entered = 0;
                for (int d = 0; d < 4; d++) {
                    int neighbour = graph.neighbour(target, d);
                    if (neighbour != MazeGraph.NONE && stamps[neighbour] == stamp) {
                        entered |= 1 << d;
                    }
                }
                rows[row * nodes + target] = (char) (length | entered << LENGTH_BITS);
            }
        }
    }

    // ---- Lengths ----

    /**
     * Length of the path along a route to a target.
     *
     * @param least 0 if a target at the route's start is reached by no step, 1 if only by a way around
     */
    public int length(long route, int least, int target) {
        int ahead = routes.ahead(route, target);
        return ahead >= least ? ahead : lengthBeyond(route, target);
    }

    /** Length of the path along a route to a target that is not in the corridor ahead. */
    public int lengthBeyond(long route, int target) {
        return Routes.steps(route) + rowLength(Routes.row(route), target);
    }

    /** Length of the path from a row's junction to a target. */
    public int rowLength(int row, int target) {
        int byFirst = lengthBy(legs[2 * target], row);
        int bySecond = lengthBy(legs[2 * target + 1], row);
        return ((byFirst | bySecond) & OWN_JUNCTION) == 0
                ? Math.min(byFirst, bySecond)
                : rows[row * nodes + target] & LENGTH_MASK;
    }

    private int lengthBy(int leg, int row) {
        return toJunctions[row * graph.junctionCount() + (leg >> 16)] + (leg & STEPS_MASK);
    }

    /** A row's entry for a target: length and neighbours, in the form of {@link #rows}. */
    private int entry(int row, int target) {
        int first = legs[2 * target];
        int byFirst = lengthBy(first, row);
        int bySecond = lengthBy(legs[2 * target + 1], row);
        int leg = byFirst <= bySecond ? first : legs[2 * target + 1];
        int neighbour = leg >> STEPS_BITS & 0xF;
        return neighbour == 0 || ((byFirst | bySecond) & OWN_JUNCTION) != 0
                ? rows[row * nodes + target]
                : Math.min(byFirst, bySecond) | neighbour << LENGTH_BITS;
    }

    /** Length of the simulator's undirected path, where neither end is the lair. */
    public int undirectedLength(int from, int to) {
        int place = routes.place(from);
        int other = routes.place(to);
        if (Routes.segment(place) == Routes.segment(other)) {
            return Math.abs(place - other);
        }
        int first = legs[2 * from];
        int second = legs[2 * from + 1];
        if (graph.isJunction(to)) {
            // A junction at the end of the corridor is reached along it, by the first direction that leads there.
            int number = graph.junctionNumber(to);
            if (first >> 16 == number) {
                return first & STEPS_MASK;
            }
            if (second >> 16 == number) {
                return second & STEPS_MASK;
            }
        }
        int firstTo = legs[2 * to];
        int secondTo = legs[2 * to + 1];
        return Math.min(
                Math.min(lengthByLegs(first, firstTo), lengthByLegs(first, secondTo)),
                Math.min(lengthByLegs(second, firstTo), lengthByLegs(second, secondTo)));
    }

    private int lengthByLegs(int leg, int other) {
        return (leg & STEPS_MASK)
                + undirected[(leg >> 16) * graph.junctionCount() + (other >> 16)]
                + (other & STEPS_MASK);
    }

    private int[] findLegs() {
        int[] found = new int[2 * nodes];
        for (int v = 0; v < graph.lair(); v++) {
            if (graph.isJunction(v)) {
                Arrays.fill(found, 2 * v, 2 * v + 2, graph.junctionNumber(v) << 16);
                continue;
            }
            int leg = 2 * v;
            for (int d = 0; d < 4; d++) {
                if (graph.isOpen(v, d)) {
                    long route = routes.leaving(v, d);
                    found[leg++] = graph.junctionNumber(routes.junction(route)) << 16 | Routes.steps(route);
                }
            }
        }
        return found;
    }

    /** Puts directions into the legs of those nodes for which {@link #entry} then says the same as the rows. */
    private void nameNeighbours() {
        for (int v = 0; v < graph.lair(); v++) {
            if (!graph.isJunction(v) && !besideJunction[v]) {
                int open = graph.openDirections(v);
                legs[2 * v] |= Integer.lowestOneBit(open) << STEPS_BITS;
                legs[2 * v + 1] |= Integer.highestOneBit(open) << STEPS_BITS;
                for (int row = 0; row < routes.rowCount(); row++) {
                    if (entry(row, v) != rows[row * nodes + v]) {
                        legs[2 * v] &= ~(0xF << STEPS_BITS);
                        legs[2 * v + 1] &= ~(0xF << STEPS_BITS);
                    }
                }
            }
        }
    }

    // ---- What lies on a path ----

    /**
     * Length of the path along a route to a target, and which neighbours of the target it enters: {@link #lengthOf} and
     * {@link #neighboursOf} take the answer apart.
     *
     * @param route on which a target at the start is reached by no step
     */
    public int approach(long route, int target) {
        int ahead = routes.ahead(route, target);
        if (ahead >= 0) {
            return ahead < 2
                    ? ahead
                    : ahead | neighbourBit(target, routes.corridorNode(route, ahead - 1)) << LENGTH_BITS;
        }
        int steps = Routes.steps(route);
        int entry = entry(Routes.row(route), target);
        int junction = routes.junction(route);
        if (target == junction) {
            return steps < 2
                    ? steps
                    : steps | neighbourBit(target, routes.corridorNode(route, steps - 1)) << LENGTH_BITS;
        }
        return steps == 0 || !besideJunction[target]
                ? entry + steps
                : entry + steps | neighbourBit(target, junction) << LENGTH_BITS;
    }

    /** The length in an answer of {@link #approach}. */
    public static int lengthOf(int approach) {
        return approach & LENGTH_MASK;
    }

    /** The neighbours in an answer of {@link #approach}: bits 0 to 3 for the directions from the target. */
    public static int neighboursOf(int approach) {
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

    /**
     * Writes the path along a route to a target.
     *
     * @param least as in {@link #length}
     * @param path receives the nodes after the start
     * @return the length
     */
    public int path(long route, int least, int target, int[] path) {
        int ahead = routes.ahead(route, target);
        boolean inCorridor = ahead >= least;
        int steps = inCorridor ? ahead : Routes.steps(route);
        int count = 0;
        while (count < steps) {
            count++;
            path[count - 1] =
                    count == steps && !inCorridor ? routes.junction(route) : routes.corridorNode(route, count);
        }
        return inCorridor ? count : rowPath(Routes.row(route), target, path, count);
    }

    /**
     * Writes the path from a row's junction to a target behind what is already written.
     *
     * @param count nodes already written
     * @return nodes written in all
     */
    public int rowPath(int row, int target, int[] path, int count) {
        return simulated.writeDirected(routes.junctionOfRow(row), target, routes.arrivalOfRow(row), path, count);
    }
}
