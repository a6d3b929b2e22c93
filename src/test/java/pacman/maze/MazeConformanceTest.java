package pacman.maze;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Properties;
import mmneat.GoldenData;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import pacman.game.Constants.DM;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GameRules;
import pacman.game.internal.Maze;

/** The four mazes against the original's, node by node, and the answers to path and move queries, hash by hash. */
@Tag("conformance")
class MazeConformanceTest {

    private static final String[] LETTERS = {"a", "b", "c", "d"};

    @ParameterizedTest
    @CsvSource({"0", "1", "2", "3"})
    void maze_isTheOriginals_nodeByNode(int index) throws IOException {
        Path folder = GoldenData.folder("mazes");
        String letter = LETTERS[index];
        if (GoldenData.isFull()) {
            assertThat(MazeText.of(new Maze(index))).isEqualTo(MazeText.of(folder.resolve(letter + ".json")));
        } else {
            Properties digests = new Properties();
            try (Reader text = Files.newBufferedReader(folder.resolve(MazeText.DIGESTS))) {
                digests.load(text);
            }
            assertThat(MazeText.digest(MazeText.of(new Maze(index)))).isEqualTo(digests.getProperty(letter));
        }
    }

    @ParameterizedTest
    @CsvSource({"0", "1", "2", "3"})
    void queries_haveTheOriginalsChecksums(int index) throws IOException {
        JsonNode expected = new ObjectMapper()
                .readTree(GoldenData.folder("mazes")
                        .resolve("path-checksums.json")
                        .toFile())
                .get(LETTERS[index]);
        Checksums actual = new Checksums(index);
        assertThat(actual.distanceSum()).isEqualTo(expected.get("distanceSum").asLong());
        assertThat(actual.undirectedPaths()).isEqualTo(summary(expected.get("pathUndirected")));
        assertThat(actual.junctionPaths()).isEqualTo(summary(expected.get("junctionPaths")));
        assertThat(actual.directedPaths()).isEqualTo(summary(expected.get("pathDirected")));
        for (DM metric : DM.values()) {
            for (String query : List.of(
                    "nextMoveTowards",
                    "nextMoveAway",
                    "approximateNextMoveTowards",
                    "approximateNextMoveAway",
                    "nextMoveTowardsDirected",
                    "nextMoveAwayDirected",
                    "closestPill",
                    "farthestPill")) {
                assertThat(Long.toString(actual.answers(query, metric)))
                        .as("%s by %s", query, metric)
                        .isEqualTo(expected.get(query).get(metric.name()).asText());
            }
        }
    }

    private static String summary(JsonNode expected) {
        return expected.get("totalLength").asLong() + " " + expected.get("hash").asText();
    }

    /** The sums and hashes as the golden data defines them. */
    private static final class Checksums {

        private final Game game;
        private final MazePaths paths;
        private final MazeGraph graph;
        private long hash;
        private long totalLength;

        Checksums(int index) {
            game = new Game(0, GameRules.mmneat().withMazes(mazes -> mazes.withInitialMaze(index)));
            paths = game.mazeTables().paths();
            graph = game.mazeTables().graph();
        }

        private void begin() {
            hash = 17;
            totalLength = 0;
        }

        private void add(long value) {
            hash = hash * 31 + value;
        }

        private void addPath(int[] path) {
            for (int node : path) {
                add(node);
            }
            totalLength += path.length;
            add(-7);
        }

        private String summary() {
            return totalLength + " " + hash;
        }

        long distanceSum() {
            long sum = 0;
            for (int from = 0; from < graph.lair(); from++) {
                for (int to = 0; to < graph.lair(); to++) {
                    sum += game.getShortestPathDistance(from, to);
                }
            }
            return sum;
        }

        String undirectedPaths() {
            begin();
            for (int from = 0; from < graph.lair(); from++) {
                for (int to = 0; to < graph.lair(); to++) {
                    addPath(game.getShortestPath(from, to));
                }
            }
            return summary();
        }

        String junctionPaths() {
            begin();
            for (int from = 0; from < graph.junctionCount(); from++) {
                for (int move = 0; move < 4; move++) {
                    if (graph.neighbour(graph.junctionNode(from), move) < 0) {
                        continue;
                    }
                    for (int to = 0; to < graph.junctionCount(); to++) {
                        int[] path = new int[paths.junctionPathLength(from, move, to)];
                        paths.writeJunctionPath(from, move, to, path, 0);
                        addPath(path);
                    }
                }
            }
            return summary();
        }

        String directedPaths() {
            begin();
            for (int from = 0; from < graph.lair(); from++) {
                for (MOVE last : MOVE.values()) {
                    if (game.getPossibleMoves(from, last) == null) {
                        continue;
                    }
                    for (int to = 0; to < graph.lair(); to++) {
                        int[] path = game.getShortestPath(from, to, last);
                        if (path.length != game.getShortestPathDistance(from, to, last)) {
                            throw new AssertionError("length of the path from " + from + " by " + last + " to " + to);
                        }
                        addPath(path);
                    }
                }
            }
            return summary();
        }

        long answers(String query, DM metric) {
            begin();
            for (int from = 0; from < graph.lair(); from += 7) {
                if (query.endsWith("Pill")) {
                    int[] pills = game.getPillIndices();
                    add(
                            query.startsWith("closest")
                                    ? game.getClosestNodeIndexFromNodeIndex(from, pills, metric)
                                    : game.getFarthestNodeIndexFromNodeIndex(from, pills, metric));
                    continue;
                }
                for (int to = 0; to < graph.lair(); to += 5) {
                    addMoves(query, from, to, metric);
                }
            }
            return hash;
        }

        private void addMoves(String query, int from, int to, DM metric) {
            if (query.equals("nextMoveTowards") || query.equals("nextMoveAway")) {
                addMove(ask(query, from, to, null, metric));
                return;
            }
            for (MOVE last : MOVE.values()) {
                if (game.getPossibleMoves(from, last) != null) {
                    addMove(ask(query, from, to, last, metric));
                }
            }
        }

        private void addMove(MOVE move) {
            add(move == null ? 9 : move.ordinal());
        }

        private MOVE ask(String query, int from, int to, MOVE last, DM metric) {
            return switch (query) {
                case "nextMoveTowards" -> game.getNextMoveTowardsTarget(from, to, metric);
                case "nextMoveAway" -> game.getNextMoveAwayFromTarget(from, to, metric);
                case "approximateNextMoveTowards" -> game.getApproximateNextMoveTowardsTarget(from, to, last, metric);
                case "approximateNextMoveAway" -> game.getApproximateNextMoveAwayFromTarget(from, to, last, metric);
                case "nextMoveTowardsDirected" -> game.getNextMoveTowardsTarget(from, to, last, metric);
                case "nextMoveAwayDirected" -> game.getNextMoveAwayFromTarget(from, to, last, metric);
                default -> throw new IllegalArgumentException(query);
            };
        }
    }
}
