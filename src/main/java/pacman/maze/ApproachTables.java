package pacman.maze;

/**
 * A table of the ends of paths: it tells for each path its length and which neighbours of its target it passes. The
 * sensor that tells from which side a ghost approaches Ms. Pac-Man reads it: her node is the target, and a ghost
 * approaches in a direction if its path passes her neighbour there.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 4.3.
 */
public final class ApproachTables {

    /*
     * What follows at the end of a route's corridor depends on the route's row alone: so the neighbours are known for
     * every row and target, about 160 rows of 1300 bytes. Rows of one target lie side by side: the ghosts' paths have
     * the same target.
     */

    private static final int LENGTH_BITS = 11;
    private static final int LENGTH_MASK = (1 << LENGTH_BITS) - 1;

    private final MazeGraph graph;
    private final MazePaths paths;
    private final Routes routes;

    /** Whether a neighbour of a node is a junction. */
    private final boolean[] besideJunction;

    /** Neighbours on the path from row r's junction to node v, as bits, at index rows v + r. */
    private final byte[] entered;

    /** The approaches of a maze. */
    public ApproachTables(MazeTables maze) {
        graph = maze.graph();
        paths = maze.paths();
        routes = paths.routes();
        besideJunction = new boolean[graph.nodeCount()];
        for (int j = 0; j < graph.junctionCount(); j++) {
            for (int d = 0; d < 4; d++) {
                if (graph.isOpen(graph.junctionNode(j), d)) {
                    besideJunction[graph.neighbour(graph.junctionNode(j), d)] = true;
                }
            }
        }
        entered = new byte[routes.rowCount() * graph.nodeCount()];
        fillEntered();
    }

    private void fillEntered() {
        int[] path = new int[MazePaths.LONGEST * graph.nodeCount()];
        int[] stamps = new int[graph.nodeCount()];
        int stamp = 0;
        for (int row = 0; row < routes.rowCount(); row++) {
            for (int target = 0; target < graph.lair(); target++) {
                int length = paths.rowPath(row, target, path, 0);
                if (length > LENGTH_MASK) {
                    throw new IllegalArgumentException(
                            "maze " + graph.name() + ": a path of " + length + " steps is longer than " + LENGTH_MASK);
                }
                stamp++;
                for (int i = 0; i < length; i++) {
                    stamps[path[i]] = stamp;
                }
                for (int d = 0; d < 4; d++) {
                    int neighbour = graph.neighbour(target, d);
                    if (neighbour != MazeGraph.NONE && stamps[neighbour] == stamp) {
                        entered[target * routes.rowCount() + row] |= (byte) (1 << d);
                    }
                }
            }
        }
    }

    /**
     * Returns, in one int, the length of the path along a route to a target and the neighbours of the target that lie
     * on the path. {@link #lengthOf} and {@link #neighboursOf} take the int apart. A path can pass more than one
     * neighbour of its target, for example a junction beside the target before it goes round to the other side. If the
     * target is the start of the route, the length is 0.
     *
     * @param route route from {@link Routes}, such as that of a ghost
     * @param target a node, not the lair
     */
    public int approach(long route, int target) {
        int ahead = routes.ahead(route, target);
        if (ahead >= 0) {
            return ahead < 2
                    ? ahead
                    : ahead | neighbourBit(target, routes.corridorNode(route, ahead - 1)) << LENGTH_BITS;
        }
        int steps = Routes.steps(route);
        int junction = routes.junction(route);
        if (target == junction) {
            return steps < 2
                    ? steps
                    : steps | neighbourBit(target, routes.corridorNode(route, steps - 1)) << LENGTH_BITS;
        }
        int row = Routes.row(route);
        int neighbours = entered[target * routes.rowCount() + row];
        if (steps > 0 && besideJunction[target]) {
            neighbours |= neighbourBit(target, junction);
        }
        return steps + paths.rowLength(row, target) | neighbours << LENGTH_BITS;
    }

    /** The length in a number that {@link #approach} returned. */
    public static int lengthOf(int approach) {
        return approach & LENGTH_MASK;
    }

    /**
     * The neighbours in a number that {@link #approach} returned: bit d is set if the path passes the neighbour of the
     * target in direction d.
     */
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
}
