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
     * A path comes to its target from one of the ends of the target's corridor, which the lengths tell. So it passes
     * the neighbour on that side. Where that is not all, the neighbours are looked up by row and target.
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

    /**
     * For a node in a corridor: bit 0 is set if its first leg leads to the corridor's lower end; from bit 1 on follows
     * the direction to the lower end, as four bits, and from bit 5 on that to the upper end. 0 for all other nodes, and
     * for nodes where a path passes other neighbours, too.
     */
    private final short[] sides;

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
        sides = new short[graph.nodeCount()];
        for (int target = 0; target < graph.lair(); target++) {
            if (!graph.isJunction(target)) {
                sides[target] = (short) findSides(target);
            }
        }
    }

    private int findSides(int target) {
        Corridors corridors = paths.corridors();
        boolean lowerFirst = !corridors.isAscending(target, 0);
        int first = 1 << corridors.firstMove(target, 0);
        int second = 1 << corridors.firstMove(target, 1);
        int found = lowerFirst ? 1 | first << 1 | second << 5 : second << 1 | first << 5;
        for (int row = 0; row < routes.rowCount(); row++) {
            int ends = paths.ends(row, routes.place(target));
            if (ends >= 0 && neighbour(ends, target, found) != entered[index(row, target)]) {
                return 0;
            }
        }
        return found;
    }

    /** Returns the neighbour on the side from which a path comes, as a bit; 0 if the path starts at that neighbour. */
    private int neighbour(int ends, int target, int side) {
        int at = Routes.position(routes.place(target));
        int byLower = (ends >> 16) + at;
        int byUpper = (ends & 0xFFFF) - at;
        if (Math.min(byLower, byUpper) == 1) {
            return 0;
        }
        return MazePaths.isByLower(byLower, byUpper, (side & 1) != 0) ? side >> 1 & 0xF : side >> 5;
    }

    private int index(int row, int target) {
        return target * routes.rowCount() + row;
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
                        entered[index(row, target)] |= (byte) (1 << d);
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
        int ends = paths.ends(row, routes.place(target));
        int side = sides[target];
        int neighbours = side == 0 || ends < 0 ? entered[index(row, target)] : neighbour(ends, target, side);
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
