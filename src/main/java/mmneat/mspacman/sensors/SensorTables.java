package mmneat.mspacman.sensors;

import pacman.game.internal.MazeDistances;
import pacman.game.internal.MazeGraph;
import pacman.game.internal.MazeTables;

/** What sensors look up about one maze. Immutable; may be shared by games and threads. */
final class SensorTables {

    final MazeGraph graph;
    final MazeDistances distances;
    final Ways ways;
    final PathTables paths;
    final PillTables pills;
    final OnwardJunctions onward;
    final WalkTables walks;

    /** Power pills close to each node, as bits. */
    final long[] closePowerPills;

    /** Distance of each node from where ghosts leave the lair. */
    final short[] fromLairExit;

    private record Key(int lookAhead, double closeness) {}

    /**
     * The tables of a maze.
     *
     * @param lookAhead steps of the walks that are looked at
     * @param closeness distance below which a power pill is close
     */
    static SensorTables of(MazeTables maze, int lookAhead, double closeness) {
        // Large, and the same whoever asks: the runs of one program share them through the maze.
        return maze.derived(
                new Key(lookAhead, closeness),
                known -> new SensorTables(known, lookAhead, closeness),
                SensorTables.class);
    }

    private SensorTables(MazeTables maze, int lookAhead, double closeness) {
        graph = maze.graph();
        distances = maze.distances();
        ways = new Ways(graph);
        paths = new PathTables(maze, ways);
        pills = new PillTables(graph, ways, paths);
        onward = new OnwardJunctions(graph, ways, paths);
        walks = new WalkTables(graph, lookAhead);
        closePowerPills = new long[graph.nodeCount()];
        fromLairExit = new short[graph.nodeCount()];
        for (int v = 0; v < graph.lair(); v++) {
            fromLairExit[v] = (short) distances.between(graph.ghostStart(), v);
            for (int power = 0; power < graph.powerPillCount(); power++) {
                if (distances.between(v, graph.powerPillNode(power)) < closeness) {
                    closePowerPills[v] |= 1L << power;
                }
            }
        }
    }
}
