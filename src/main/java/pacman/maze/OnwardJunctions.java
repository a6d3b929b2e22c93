package pacman.maze;

/**
 * The junctions beyond the next one: where the moves at the next junction lead, the paths to there, and which of the moves lead
 * back to where Ms. Pac-Man is.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 4.10.
 */
public final class OnwardJunctions {

    /*
     * From the next junction on everything depends only on the row, that is, on this junction and the move that enters it.
     * Per row and onward move there are the junction that is reached next, and the path there from the row's junction: its
     * length and the set of its nodes, as bits. Which moves lead back depends on Ms. Pac-Man's node: four bits for each direction
     * of leaving it.
     */

    private final MazeGraph graph;

    /** Longs in a set of nodes. */
    private final int words;

    /** Junction reached by move m at row r's junction, at index 4 r + m, or NONE. */
    private final int[] junctions;

    /** Steps of the path from row r's junction to there, at index 4 r + m. */
    private final int[] lengths;

    /** Steps of the longest of a row's paths. */
    private final int[] longest;

    /** Nodes of that path, {@link #words} longs from index words (4 r + m). */
    private final long[] nodes;

    /** Moves, as bits, that lead on from the next junction and not back, for node v and direction d at index 4 v + d. */
    private final byte[] moves;

    public OnwardJunctions(MazeGraph graph, Routes routes, PathTables paths) {
        this.graph = graph;
        words = (graph.nodeCount() + 63) / 64;
        int rows = routes.rowCount();
        junctions = new int[4 * rows];
        lengths = new int[4 * rows];
        longest = new int[rows];
        nodes = new long[4 * rows * words];
        moves = new byte[4 * graph.nodeCount()];
        int[] path = new int[PathTables.LONGEST * graph.nodeCount()];
        for (int row = 0; row < rows; row++) {
            for (int m = 0; m < 4; m++) {
                fillOnward(routes, paths, row, m, path);
            }
        }
        for (int v = 0; v < graph.lair(); v++) {
            for (int d = 0; d < 4; d++) {
                if (graph.isOpen(v, d)) {
                    moves[4 * v + d] = (byte) movesOn(routes, v, d);
                }
            }
        }
    }

    private void fillOnward(Routes routes, PathTables paths, int row, int move, int[] path) {
        int from = routes.junctionOfRow(row);
        int index = 4 * row + move;
        junctions[index] = CorridorPositions.NONE;
        if (graph.isOpen(from, move)) {
            junctions[index] = routes.junction(routes.leaving(from, move));
            lengths[index] = paths.rowPath(row, junctions[index], path, 0);
            longest[row] = Math.max(longest[row], lengths[index]);
            for (int i = 0; i < lengths[index]; i++) {
                nodes[index * words + (path[i] >> 6)] |= 1L << path[i];
            }
        }
    }

    private int movesOn(Routes routes, int node, int direction) {
        int next = routes.junction(routes.leaving(node, direction));
        int bits = 0;
        for (int m = 0; m < 4; m++) {
            if (graph.isOpen(next, m)) {
                long route = routes.leaving(next, m);
                // The route back is excluded because she is on it or at its end.
                if (routes.junction(route) != node && routes.ahead(route, node) < 0) {
                    bits |= 1 << m;
                }
            }
        }
        return bits;
    }

    /** Moves, as bits, that lead on from the next junction in a direction. */
    public int moves(int node, int direction) {
        return moves[4 * node + direction];
    }

    /** Number of the path by an onward move of a row. */
    public static int path(int row, int move) {
        return 4 * row + move;
    }

    /** Junction at the end of an onward path. */
    public int end(int path) {
        return junctions[path];
    }

    /** Steps of an onward path. */
    public int length(int path) {
        return lengths[path];
    }

    /** Steps of the longest onward path of a row. */
    public int longest(int row) {
        return longest[row];
    }

    /** Whether a node lies on an onward path, its end included. */
    public boolean passes(int path, int node) {
        return (nodes[path * words + (node >> 6)] >>> node & 1) != 0;
    }
}
