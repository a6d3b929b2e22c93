package pacman.maze;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import pacman.game.Game;
import pacman.game.internal.AStar;
import pacman.game.internal.Maze;

/** The tables against the plain form of the rules, and facts of the four mazes. */
class MazePathsTest {

    @ParameterizedTest
    @CsvSource({"0", "1", "2", "3"})
    void paths_areThoseOfThePlainForm(int maze) {
        MazeTables tables = Mazes.standard().get(maze);
        MazeGraph graph = tables.graph();
        MazePaths paths = tables.paths();
        PlainPaths plain = new PlainPaths(tables);
        ResumableRandom random = new ResumableRandom(maze);
        for (int trial = 0; trial < 5000; trial++) {
            int from = random.nextInt(graph.lair());
            int to = random.nextInt(graph.lair());
            int lastMove = random.nextInt(5);
            assertThat(paths.undirectedPath(from, to))
                    .as("from %d to %d", from, to)
                    .isEqualTo(ints(plain.undirected(from, to)));
            assertThat(paths.undirectedLength(from, to)).isEqualTo(paths.undirectedPath(from, to).length);
            assertThat(paths.directedPath(from, to, lastMove))
                    .as("from %d to %d after %d", from, to, lastMove)
                    .isEqualTo(ints(plain.directed(from, to, lastMove)));
            assertThat(paths.directedLength(from, to, lastMove))
                    .isEqualTo(paths.directedPath(from, to, lastMove).length);
        }
    }

    @Test
    void searchForANodeThatIsNeverReached_answersThatNodeAlone() {
        Game game = new Game(0);
        AStar search = new AStar();
        search.createGraph(game.getCurrentMaze().graph);
        int lair = Mazes.standard().get(0).graph().lair();
        assertThat(search.computePathsAStar(5, lair, game)).containsExactly(lair);
        assertThat(search.computePathsAStar(5, 5, game)).containsExactly(5);
    }

    private static int[] ints(java.util.List<Integer> path) {
        return path.stream().mapToInt(Integer::intValue).toArray();
    }

    /**
     * Nodes, Ms. Pac-Man's start, ghost start, pills, junctions, largest distance; docs/specification/simulator.md,
     * section 1.3.
     */
    @ParameterizedTest
    @CsvSource({
        "0, a, 1293, 978, 498, 220, 38, 196, 44",
        "1, b, 1319, 973, 493, 240, 36, 198, 46",
        "2, c, 1380, 1060, 525, 238, 44, 221, 46",
        "3, d, 1309, 989, 487, 234, 40, 216, 38"
    })
    void mazes_haveTheFactsOfTheSpecification(
            int maze,
            String name,
            int nodes,
            int pacManStart,
            int ghostStart,
            int pills,
            int junctions,
            int farthest,
            int pillsNearPowerPills) {
        MazeTables tables = Mazes.standard().get(maze);
        MazeGraph graph = tables.graph();
        assertThat(graph.name()).isEqualTo(name);
        assertThat(graph.nodeCount()).isEqualTo(nodes);
        assertThat(graph.pacManStart()).isEqualTo(pacManStart);
        assertThat(graph.ghostStart()).isEqualTo(ghostStart);
        assertThat(graph.pillCount()).isEqualTo(pills);
        assertThat(graph.powerPillCount()).isEqualTo(4);
        assertThat(graph.junctionCount()).isEqualTo(junctions);
        assertThat(Arrays.stream(Maze.of(tables).shortestPathDistances).max()).hasValue(farthest);
        int near = 0;
        for (int word = 0; word < graph.pillWords(); word++) {
            near += Long.bitCount(graph.pillsNearPowerPills(word));
        }
        assertThat(near).isEqualTo(pillsNearPowerPills);
    }

    /** Undirected paths that are longer than necessary; docs/specification/simulator.md, section 4.4. */
    @ParameterizedTest
    @CsvSource({"0, 1004", "1, 236", "2, 3624", "3, 12"})
    void undirectedPaths_areAsInexactAsTheOriginals(int maze, int expected) {
        MazeTables tables = Mazes.standard().get(maze);
        int longer = 0;
        for (int from = 0; from < tables.graph().lair(); from++) {
            for (int to = 0; to < tables.graph().lair(); to++) {
                longer += tables.paths().undirectedLength(from, to)
                                > tables.distances().between(from, to)
                        ? 1
                        : 0;
            }
        }
        assertThat(longer).isEqualTo(expected);
    }

    @Test
    void lair_isOnNoPath() {
        MazeTables tables = Mazes.standard().get(0);
        int lair = tables.graph().lair();
        assertThat(tables.distances().between(lair, 0)).isEqualTo(-1);
        assertThat(tables.distances().between(lair, lair)).isZero();
        assertThat(tables.paths().directedPath(lair, 0, 0)).isEmpty();
        assertThat(tables.paths().undirectedPath(lair, lair)).isEmpty();
        assertThatThrownBy(() -> tables.paths().directedPath(0, lair, 0)).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> tables.paths().undirectedPath(0, lair)).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> tables.paths().undirectedPath(lair, 0)).isInstanceOf(IndexOutOfBoundsException.class);
    }
}
