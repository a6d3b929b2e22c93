package pacman.maze;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The sensors' tables against the simulator's paths, which are listed and compared node by node. */
class RouteTablesTest {

    private static final int ROUNDS = 20_000;

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3})
    void lengths_areThoseOfTheListedPaths(int maze) {
        MazeTables tables = Mazes.standard().get(maze);
        MazePaths paths = tables.paths();
        PlainPaths plain = new PlainPaths(tables);
        int[] path = new int[MazePaths.LONGEST * tables.graph().nodeCount()];
        for (int row = 0; row < paths.routes().rowCount(); row++) {
            for (int target = 0; target < tables.graph().lair(); target++) {
                assertThat(paths.rowLength(row, target)).isEqualTo(paths.rowPath(row, target, path, 0));
            }
        }
        ResumableRandom random = new ResumableRandom(maze);
        for (int round = 0; round < ROUNDS; round++) {
            int from = random.nextInt(tables.graph().lair());
            int to = random.nextInt(tables.graph().lair());
            assertThat(paths.undirectedLength(from, to))
                    .isEqualTo(plain.undirected(from, to).size());
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3})
    void neighboursThatAnApproachEnters_areThoseOnThePath(int maze) {
        MazeTables tables = Mazes.standard().get(maze);
        MazeGraph graph = tables.graph();
        Routes routes = tables.paths().routes();
        ApproachTables approaches = new ApproachTables(tables);
        ResumableRandom random = new ResumableRandom(maze);
        for (int round = 0; round < ROUNDS; round++) {
            int from = random.nextInt(graph.lair());
            int to = random.nextInt(graph.lair());
            int lastMove = random.nextInt(5);
            int[] path = tables.paths().directedPath(from, to, lastMove);
            int approach = approaches.approach(routes.continuing(from, lastMove), to);
            assertThat(ApproachTables.lengthOf(approach)).isEqualTo(path.length);
            for (int d = 0; d < 4; d++) {
                int neighbour = graph.neighbour(to, d);
                boolean entered = neighbour >= 0 && Arrays.stream(path).anyMatch(node -> node == neighbour);
                assertThat(ApproachTables.neighboursOf(approach) >> d & 1)
                        .as("from %d after %d to %d, neighbour %d", from, lastMove, to, d)
                        .isEqualTo(entered ? 1 : 0);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3})
    void lanes_sayWhatComparingPathsSays(int maze) {
        MazeTables tables = Mazes.standard().get(maze);
        MazeGraph graph = tables.graph();
        MazePaths paths = tables.paths();
        Routes routes = paths.routes();
        OnwardJunctions onward = new OnwardJunctions(tables);
        ResumableRandom random = new ResumableRandom(maze);
        for (int round = 0; round < ROUNDS; round++) {
            int row = Routes.row(anyRoute(graph, routes, random));
            int junction = routes.junctionOfRow(row);
            int other = random.nextInt(routes.rowCount());
            int more = random.nextInt(200) - 100;
            int node = random.nextInt(graph.lair());
            long arriving = onward.arriving(row, other, more);
            long fromLair = onward.arrivingFromLair(row, more);
            for (int lane = 0; lane < 4; lane++) {
                int target = onward.target(row, lane);
                long flag = OnwardJunctions.flags(1 << lane);
                if (target < 0) {
                    assertThat((arriving | fromLair) & flag).isZero();
                    continue;
                }
                int[] path = 1 << lane == onward.ownBit(row)
                        ? new int[0]
                        : tables.paths().directedPath(junction, target, routes.arrivalOfRow(row));
                assertThat(onward.length(row, lane)).isEqualTo(path.length);
                assertThat((arriving & flag) != 0).isEqualTo(paths.rowLength(other, target) <= path.length + more);
                assertThat((fromLair & flag) != 0)
                        .isEqualTo(tables.distances().between(graph.ghostStart(), target) <= path.length + more);
                assertThat((onward.atLeast(row, more) & flag) != 0).isEqualTo(path.length >= more);
                boolean isOn = node == junction || Arrays.stream(path).anyMatch(passed -> passed == node);
                assertThat(onward.passing(row, routes.place(node)) >> lane & 1).isEqualTo(isOn ? 1 : 0);
                assertThat(onward.endingAt(row, routes.place(node)) >> lane & 1).isEqualTo(target == node ? 1 : 0);
            }
        }
    }

    private static long anyRoute(MazeGraph graph, Routes routes, ResumableRandom random) {
        int node = random.nextInt(graph.lair());
        int direction = random.nextInt(4);
        while (!graph.isOpen(node, direction)) {
            direction = random.nextInt(4);
        }
        return routes.leaving(node, direction);
    }
}
