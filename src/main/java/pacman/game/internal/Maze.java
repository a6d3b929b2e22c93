package pacman.game.internal;

import pacman.maze.MazeGraph;
import pacman.maze.MazeTables;
import pacman.maze.Mazes;

/**
 * A maze in the competition's interface. All games share one object: do not modify its arrays.
 *
 * <p>Source: docs/specification/simulator.md, section 1.4.
 */
public final class Maze {

    /** Search for paths that do not turn back. */
    public AStar astar = new AStar();
    /** Path distance of nodes s and t with s at most t, at index t (t + 1) / 2 + s. */
    public int[] shortestPathDistances;
    /** Node of each pill, by number. */
    public int[] pillIndices;
    /** Node of each power pill, by number. */
    public int[] powerPillIndices;
    /** Nodes with three or more neighbours. */
    public int[] junctionIndices;

    public int initialPacManNodeIndex;
    public int lairNodeIndex;
    public int initialGhostNodeIndex;
    /** All nodes, the lair last. */
    public Node[] graph;
    /** Letter of the maze, or file name of a drawing. */
    public String name;

    /** Returns the shared object of a maze, always the same for the same tables. */
    public static Maze of(MazeTables tables) {
        return tables.derived(Maze.class, Maze::new, Maze.class);
    }

    /** One of the four mazes, 0 to 3. */
    public Maze(int index) {
        this(Mazes.standard().get(index));
    }

    private Maze(MazeTables tables) {
        MazeGraph source = tables.graph();
        shortestPathDistances = tables.distances().triangular();
        pillIndices = source.pillNodes();
        powerPillIndices = source.powerPillNodes();
        junctionIndices = source.junctionNodes();
        initialPacManNodeIndex = source.pacManStart();
        lairNodeIndex = source.lair();
        initialGhostNodeIndex = source.ghostStart();
        name = source.name();
        graph = new Node[source.nodeCount()];
        for (int node = 0; node < graph.length; node++) {
            int[] neighbours = new int[4];
            for (int direction = 0; direction < 4; direction++) {
                neighbours[direction] = source.neighbour(node, direction);
            }
            graph[node] = new Node(
                    node,
                    source.x(node),
                    source.y(node),
                    source.pillNumber(node),
                    source.powerPillNumber(node),
                    neighbours);
        }
        astar.createGraph(graph);
    }
}
