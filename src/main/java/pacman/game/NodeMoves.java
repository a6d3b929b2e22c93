package pacman.game;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import pacman.game.Constants.MOVE;
import pacman.maze.MazeGraph;
import pacman.maze.MazeTables;

/**
 * Arrays of the directions and neighbours of each node, for entries that use them in every step. All games share them:
 * do not modify them.
 *
 * <p>Source: docs/specification/simulator.md, section 1.4.
 */
final class NodeMoves {

    private static final MOVE[] MOVES = MOVE.values();

    /** Directions by node and last move, index 5 node + last move; null if the node cannot be entered by that move. */
    private final MOVE[][] moves;
    /** Neighbours, with the same index. */
    private final int[][] neighbours;

    /** Returns the directions of a maze, computed once and shared by all games. */
    static NodeMoves of(MazeTables tables) {
        return tables.derived(NodeMoves.class, maze -> new NodeMoves(maze.graph()), NodeMoves.class);
    }

    private NodeMoves(MazeGraph graph) {
        moves = new MOVE[5 * graph.nodeCount()][];
        neighbours = new int[5 * graph.nodeCount()][];
        MOVE[] open = new MOVE[4];
        int[] next = new int[4];
        for (int node = 0; node < graph.nodeCount(); node++) {
            for (int lastMove = 0; lastMove <= 4; lastMove++) {
                int back = lastMove < 4 ? MazeGraph.opposite(lastMove) : -1;
                if (back >= 0 && graph.neighbour(node, back) < 0) {
                    continue;
                }
                int count = 0;
                for (int direction = 0; direction < 4; direction++) {
                    if (direction != back && graph.neighbour(node, direction) >= 0) {
                        open[count] = MOVES[direction];
                        next[count++] = graph.neighbour(node, direction);
                    }
                }
                moves[5 * node + lastMove] = Arrays.copyOf(open, count);
                neighbours[5 * node + lastMove] = Arrays.copyOf(next, count);
            }
        }
    }

    /** Returns the directions except back; null if the node cannot be entered by that move. */
    MOVE @Nullable [] moves(int node, @Nullable MOVE lastMove) {
        return lastMove == null ? null : moves[5 * node + lastMove.ordinal()];
    }

    /** Returns the neighbours in those directions. */
    int @Nullable [] neighbours(int node, @Nullable MOVE lastMove) {
        return lastMove == null ? null : neighbours[5 * node + lastMove.ordinal()];
    }
}
