package pacman.maze;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GameRules;

/** Drawings by users: a user's maze can be played, and an error message names the place of the fault. */
class MazeDrawingTest {

    /** Two loops joined by a single corridor: harder for path search than any of the four mazes. */
    private static final String[] FIFTH = {
        "#.........#######.........##",
        "#.#######.#######.#######.##",
        "#.#######.#######.#######.##",
        "#o..---.............---..o##",
        "#.#######.#######.#######.##",
        "#.#######.#######.#######.##",
        "#.#######.#######.#######.##",
        "#.........#######.........##",
        "#########.##################",
        "#########.##################",
        "-.........................P-",
        "#.#######.#######.#######.##",
        "#.#######.##LL###.#######.##",
        "#........................G##",
    };

    private static List<String> fifthMaze() {
        List<String> rows = new ArrayList<>(List.of(FIFTH));
        while (rows.size() < MazeDrawing.ROWS) {
            rows.add("#".repeat(MazeDrawing.COLUMNS));
        }
        return rows;
    }

    private static String text(List<String> rows) {
        return String.join("\n", rows) + "\n";
    }

    private static String withRow(int row, String tiles) {
        List<String> rows = fifthMaze();
        rows.set(row - 1, tiles);
        return text(rows);
    }

    private static void assertError(String drawing, String message) {
        assertThatThrownBy(() -> MazeTables.parse("fifth.txt", drawing))
                .isInstanceOf(MazeFormatException.class)
                .hasMessageStartingWith("fifth.txt:")
                .hasMessageContaining(message);
    }

    @Test
    void userMaze_isPlayed(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("fifth.txt");
        Files.writeString(file, "; my maze\n\n" + text(fifthMaze()));
        MazeTables tables = MazeTables.read(file);
        GameRules rules = GameRules.competition().withMazes(mazes -> mazes.withMazes(Mazes.of(List.of(tables))));
        Game game = new Game(1, rules);
        ResumableRandom random = new ResumableRandom(1);
        while (!game.gameOver()) {
            game.advanceGame(MOVE.values()[random.nextInt(5)], null);
        }
        assertThat(game.getScore()).isPositive();
        assertThat(game.getCurrentMaze().name).isEqualTo(file.toString());
        assertThat(game.getNumberOfPowerPills()).isEqualTo(2);
    }

    @Test
    void userMaze_hasPathsBetweenAllNodes() {
        MazeTables tables = MazeTables.parse("fifth.txt", text(fifthMaze()));
        MazeGraph graph = tables.graph();
        for (int from = 0; from < graph.lair(); from++) {
            for (int to = 0; to < graph.lair(); to += 3) {
                assertIsPath(graph, from, to, tables.paths().undirectedPath(from, to));
                for (int move = 0; move < 4; move++) {
                    if (graph.neighbour(from, move ^ 2) >= 0) {
                        int[] path = tables.paths().directedPath(from, to, move);
                        assertIsPath(graph, from, to, path);
                        assertThat(path).hasSize(tables.paths().directedLength(from, to, move));
                        assertThat(path.length)
                                .isGreaterThanOrEqualTo(tables.distances().between(from, to));
                    }
                }
            }
        }
    }

    private static void assertIsPath(MazeGraph graph, int from, int to, int[] path) {
        int node = from;
        for (int next : path) {
            boolean isBeside = false;
            for (int move = 0; move < 4; move++) {
                isBeside |= graph.neighbour(node, move) == next;
            }
            if (!isBeside) {
                throw new AssertionError("path from " + from + " to " + to + " jumps from " + node + " to " + next);
            }
            node = next;
        }
        assertThat(node).isEqualTo(to);
    }

    @Test
    void unknownCharacter_isNamed() {
        assertError(withRow(1, "#....x....#######.........##"), ":1:6: row 1, column 5: unknown character 'x'");
    }

    @Test
    void raggedLine_isNamed() {
        assertError(withRow(2, "#.#######.#######.#######."), ":2:27: row 2, column 26: ragged line with 26 tiles");
        assertError(withRow(2, "#.#######.#######.#######.###"), ":2:29: row 2, column 28: ragged line with 29 tiles");
    }

    @Test
    void missingStart_isNamed() {
        assertError(text(fifthMaze()).replace('P', '.'), "row 1, column 0: missing start: no 'P'");
        assertError(text(fifthMaze()).replace('G', '.'), "missing start: no 'G'");
        assertError(text(fifthMaze()).replace('L', '#'), "missing start: no 'L'");
    }

    @Test
    void startInTwoPlaces_isNamed() {
        assertError(withRow(1, "#P........#######.........##"), "'P' (Ms. Pac-Man's start) occurs more than once");
    }

    @Test
    void lairOnCorridor_isNamed() {
        assertError(
                text(fifthMaze()) + "corridor column 12.5, rows 11 to 14\n",
                "row 13, column 12: the lair must not be on a corridor");
    }

    @Test
    void deadEnd_isNamed() {
        assertError(withRow(5, "#.#######.#######.#######.#."), "row 5, column 27: dead end");
        assertError(withRow(2, "#.####.##.#######.#######.##"), "row 2, column 6: dead end");
    }

    @Test
    void tunnelWithoutOtherSide_isNamed() {
        assertError(
                withRow(11, "-.........................P#"), "dead end: this tunnel has no opening on the other side");
    }

    @Test
    void corridorAlongTheBorder_isNamed() {
        List<String> rows = fifthMaze();
        for (int row = 1; row <= 5; row++) {
            rows.set(row, "." + rows.get(row).substring(1));
        }
        assertError(text(rows), "fifth.txt:2:1: row 2, column 0: corridor along the border: only tunnels");
    }

    @Test
    void unreachableCorridor_isNamed() {
        List<String> rows = fifthMaze();
        rows.set(20, "####....####################");
        rows.set(21, "####.##.####################");
        rows.set(22, "####....####################");
        assertError(text(rows), ":21:5: row 21, column 4: unreachable corridor");
    }

    @Test
    void fieldWithHardlyAnyWalls_isTooMuchCorridor() {
        List<String> rows = new ArrayList<>();
        while (rows.size() < MazeDrawing.ROWS) {
            rows.add("#" + ".".repeat(MazeDrawing.COLUMNS - 2) + "#");
        }
        rows.set(9, "#............G.............#");
        rows.set(12, "#...........#LL#...........#");
        rows.set(20, "#............P.............#");
        assertError(text(rows), "corridors too long: at most 4095 steps in all");
    }

    @Test
    void noPills_isAnError() {
        assertError(text(fifthMaze()).replace('.', '-'), "no pills");
    }

    @Test
    void noJunction_isAnError() {
        List<String> rows = new ArrayList<>(List.of("#P...#######################", "#.LL.#######################"));
        rows.add("#.##G#######################");
        rows.add("#....#######################");
        while (rows.size() < MazeDrawing.ROWS) {
            rows.add("#".repeat(MazeDrawing.COLUMNS));
        }
        assertError(text(rows), "no junction");
    }

    @Test
    void wrongNumberOfRows_isNamed() {
        List<String> rows = fifthMaze();
        assertError(text(rows.subList(0, 20)), "row 21, column 0: missing");
        rows.add("#".repeat(MazeDrawing.COLUMNS));
        assertError(text(rows), ":30:1: one row too many");
    }

    @Test
    void badCorridorLine_isNamed() {
        assertError(text(fifthMaze()) + "corridor from here to there\n", ":30:1: corridor not understood");
        assertError(text(fifthMaze()) + "corridor column 3.1, rows 4 to 5\n", ":30:17: column 3.1 is not a multiple");
        assertError(text(fifthMaze()) + "corridor column 3, columns 4 to 5\n", ":30:1: corridor not understood");
        assertError(
                text(fifthMaze()) + "corridor column 3, rows 4 to 50\n",
                "row 50 is not a multiple of 0.25 from 1 to 29");
        assertError(text(fifthMaze()) + "corridor column 3, rows 5 to 4\n", "the corridor ends before it begins");
    }

    @Test
    void markWithoutCorridor_isNamed() {
        assertError(withRow(20, "#####:######################"), "row 20, column 5: ':' marks a corridor off the grid");
    }
}
