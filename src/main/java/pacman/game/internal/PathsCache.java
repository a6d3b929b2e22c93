package pacman.game.internal;

import java.util.HashMap;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.maze.MazeGraph;
import pacman.maze.Mazes;

/**
 * The paths of one of the four mazes in the competition's interface, for use without a game. They are computed at the
 * first call and shared with all games.
 *
 * <p>Source: docs/specification/simulator.md, sections 1.4 and 4.4.
 */
public class PathsCache {

    /** Number of a junction by its node. */
    public HashMap<Integer, Integer> junctionIndexConverter = new HashMap<>();

    /** All nodes by number; the element type is not public, as in the competition's interface. */
    public DNode[] nodes;
    /** All junctions by number; the element type is not public, as in the competition's interface. */
    public Junction[] junctions;
    /**
     * A game at the start of the maze's level, which the competition's interface makes public. All entries share it: do
     * not advance it. The methods of this class do not read this field, so that paths stay right if an entry replaces
     * it.
     */
    public Game game;

    /** The same game, which stays even if the public field is overwritten. */
    private final Game inMaze;

    /** Creates the paths of a maze, 0 to 3. */
    public PathsCache(int mazeIndex) {
        MazeGraph graph = Mazes.standard().get(mazeIndex).graph();
        nodes = new DNode[graph.nodeCount()];
        for (int node = 0; node < nodes.length; node++) {
            nodes[node] = new DNode(node, graph.isJunction(node));
        }
        junctions = new Junction[graph.junctionCount()];
        for (int junction = 0; junction < junctions.length; junction++) {
            junctions[junction] = new Junction(graph.junctionNode(junction), junction);
            junctionIndexConverter.put(graph.junctionNode(junction), junction);
        }
        inMaze = new Game(0, mazeIndex);
        game = inMaze;
    }

    /** {@link Game#getShortestPath(int, int)}. */
    public int[] getPathFromA2B(int a, int b) {
        return inMaze.getShortestPath(a, b);
    }

    /** {@link Game#getShortestPathDistance(int, int, MOVE)}. */
    public int getPathDistanceFromA2B(int a, int b, MOVE lastMoveMade) {
        return inMaze.getShortestPathDistance(a, b, lastMoveMade);
    }

    /** {@link Game#getShortestPath(int, int, MOVE)}. */
    public int[] getPathFromA2B(int a, int b, MOVE lastMoveMade) {
        return inMaze.getShortestPath(a, b, lastMoveMade);
    }
}
