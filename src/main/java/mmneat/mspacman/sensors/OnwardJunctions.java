package mmneat.mspacman.sensors;

import java.util.Arrays;
import pacman.game.internal.MazeGraph;

/**
 * The junctions beyond the next one: where the moves at the next junction lead, without those that lead back to where Ms.
 * Pac-Man is.
 *
 * <p>Source: spec/mspacman-task.md, section 4.10.
 */
final class OnwardJunctions {

    /** Most onward moves: of four, one leads back. */
    static final int MOST = 3;

    /** At most three junctions for node v and direction d, at index 3 (4 v + d), in the order of the moves; the rest NONE. */
    private final int[] beyond;

    OnwardJunctions(MazeGraph graph, PathTables paths) {
        beyond = new int[12 * graph.nodeCount()];
        Arrays.fill(beyond, CorridorPositions.NONE);
        for (int v = 0; v < graph.nodeCount(); v++) {
            for (int d = 0; d < 4; d++) {
                if (graph.neighbour(v, d) != CorridorPositions.NONE) {
                    fill(graph, paths, v, d);
                }
            }
        }
    }

    private void fill(MazeGraph graph, PathTables paths, int node, int direction) {
        int next = paths.junction(paths.leaving(node, direction));
        int count = 0;
        for (int m = 0; m < 4; m++) {
            if (graph.neighbour(next, m) != CorridorPositions.NONE) {
                long way = paths.leaving(next, m);
                int second = paths.junction(way);
                // The way back is excluded because she is on it or at its end.
                if (second != node && paths.ahead(way, node) < 0) {
                    beyond[3 * (4 * node + direction) + count++] = second;
                }
            }
        }
    }

    /**
     * The junction reached by one of the onward moves.
     *
     * @param number 0 to 2
     * @return its node, or {@link CorridorPositions#NONE} if there are fewer
     */
    int beyond(int node, int direction, int number) {
        return beyond[3 * (4 * node + direction) + number];
    }
}
