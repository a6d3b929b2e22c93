package pacman.game.internal;

import java.util.Arrays;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.maze.MazeGraph;
import pacman.maze.NonReversingSearch;

/**
 * The search for a path without turning back, in the competition's interface. It runs {@link NonReversingSearch}, the
 * search that also finds the stored paths between junctions of {@link PathsCache} and {@link pacman.maze.MazePaths}.
 *
 * <p>Source: docs/specification/simulator.md, section 4.3.
 */
public class AStar {

    private short[] neighbours = {};

    /** Creates an empty graph; {@link #createGraph} sets its nodes. */
    public AStar() {}

    /** Sets the graph, in which node i must be at index i. */
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
     * Returns the path from a start to a target, including both, given the last move to the start.
     *
     * @param game provides the distances that guide the search
     */
    public synchronized int[] computePathsAStar(int start, int target, MOVE lastMove, Game game) {
        return new NonReversingSearch(neighbours)
                .path(start, target, lastMove.ordinal(), game::getShortestPathDistance);
    }

    /** Returns the path from a start that may be left in any direction. */
    public synchronized int[] computePathsAStar(int start, int target, Game game) {
        return computePathsAStar(start, target, MOVE.NEUTRAL, game);
    }

    /** Does nothing: each search is independent of earlier ones. */
    public void resetGraph() {}
}
