package mmneat.mspacman.sensors;

import pacman.maze.ApproachTables;
import pacman.maze.MazeDistances;
import pacman.maze.MazeGraph;
import pacman.maze.MazePaths;
import pacman.maze.MazeTables;
import pacman.maze.OnwardJunctions;
import pacman.maze.PillTables;
import pacman.maze.Routes;
import pacman.maze.WalkTables;

/** The tables of one maze that sensors use. Immutable; games and threads may share them. */
final class SensorTables {

    final MazeGraph graph;
    final MazeDistances distances;
    final Routes routes;
    final MazePaths paths;
    final ApproachTables approaches;
    final PillTables pills;
    final PillTables powerPills;
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
        // Large, and independent of the caller: the runs of one program share them through the maze.
        return maze.derived(
                new Key(lookAhead, closeness),
                known -> new SensorTables(known, lookAhead, closeness),
                SensorTables.class);
    }

    private SensorTables(MazeTables maze, int lookAhead, double closeness) {
        graph = maze.graph();
        distances = maze.distances();
        paths = maze.paths();
        routes = paths.routes();
        approaches = new ApproachTables(maze);
        pills = PillTables.ofPills(graph, paths);
        powerPills = PillTables.ofPowerPills(graph, paths);
        onward = new OnwardJunctions(maze);
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
