package pacman.game.internal;

import java.util.Arrays;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.maze.MazeGraph;
import pacman.maze.NonReversingSearch;

/**
 * Search for a path without turning back, as competition entries call it. The same search fills the path cache.
 *
 * <p>Source: docs/specification/simulator.md, section 4.3.
 */
public class AStar {

    private short[] neighbours = {};

    /** An empty graph; {@link #createGraph} gives it nodes. */
    public AStar() {}

    /** Takes over a graph, in which node i must be at index i. */
    public void createGraph(Node[] nodes) {
        short[] table = new short[MazeGraph.MOVES * nodes.length];
        Arrays.fill(table, (short) -1);
        for (Node node : nodes) {
            node.neighbourhood.forEach(
                    (move, to) -> table[MazeGraph.MOVES * node.nodeIndex + move.ordinal()] = to.shortValue());
        }
        neighbours = table;
    }

    /**
     * The path from a start, reached by a last move, to a target: both included.
     *
     * @param game gives the distances that guide the search
     */
    public synchronized int[] computePathsAStar(int start, int target, MOVE lastMove, Game game) {
        return new NonReversingSearch(neighbours)
                .path(start, target, lastMove.ordinal(), game::getShortestPathDistance);
    }

    /** The path from a start that may be left in any direction. */
    public synchronized int[] computePathsAStar(int start, int target, Game game) {
        return computePathsAStar(start, target, MOVE.NEUTRAL, game);
    }

    /** Forgets the last search. Each search starts afresh anyway. */
    public void resetGraph() {}
}
