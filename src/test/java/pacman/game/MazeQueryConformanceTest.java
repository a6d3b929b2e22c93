package pacman.game;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.stream.IntStream;
import java.util.zip.GZIPInputStream;
import mmneat.GoldenData;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import pacman.game.Constants.DM;
import pacman.game.Constants.MOVE;
import pacman.game.internal.Maze;

/** Queries of the four mazes give the original's results. */
@Tag("conformance")
class MazeQueryConformanceTest {

    private static final ObjectMapper JSON = new ObjectMapper();

    private Game game;

    @Test
    void queries_haveTheOriginalsAnswers() throws IOException {
        int queries = 0;
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(
                        Files.newInputStream(GoldenData.folder("traces").resolve("queries-maze.jsonl.gz"))),
                StandardCharsets.UTF_8))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                JsonNode query = JSON.readTree(line);
                if (query.isObject()) {
                    enter(query);
                    continue;
                }
                queries++;
                assertThat(JSON.valueToTree(answer(query)).toString())
                        .as(line)
                        .isEqualTo(query.get(query.size() - 1).toString());
            }
        }
        assertThat(queries).isEqualTo(49_000);
    }

    private void enter(JsonNode maze) {
        game = new Game(
                0,
                GameRules.mmneat()
                        .withMazes(
                                mazes -> mazes.withInitialMaze(maze.get("maze").asInt())));
        Maze current = game.getCurrentMaze();
        assertThat(current.name).isEqualTo(maze.get("name").asText());
        assertThat(game.getNumberOfNodes()).isEqualTo(maze.get("nodes").asInt());
        assertThat(current.initialPacManNodeIndex)
                .isEqualTo(maze.get("initialPacMan").asInt());
        assertThat(current.lairNodeIndex).isEqualTo(maze.get("lair").asInt());
        assertThat(current.initialGhostNodeIndex)
                .isEqualTo(maze.get("initialGhosts").asInt());
    }

    private Object answer(JsonNode query) {
        int node = query.get(2).asInt();
        int other = query.get(3).asInt();
        return switch (query.get(0).asText()) {
            case "distance" -> game.getShortestPathDistance(node, other);
            case "distanceLast" -> game.getShortestPathDistance(node, other, move(query, 4));
            case "path" -> game.getShortestPath(node, other);
            case "pathLast" -> game.getShortestPath(node, other, move(query, 4));
            case "metric" -> Double.toString(game.getDistance(node, other, metric(query, 4)));
            case "metricLast" -> Double.toString(game.getDistance(node, other, move(query, 4), metric(query, 5)));
            case "towards" -> code(game.getNextMoveTowardsTarget(node, other, metric(query, 4)));
            case "away" -> code(game.getNextMoveAwayFromTarget(node, other, metric(query, 4)));
            case "towardsLast" -> code(game.getNextMoveTowardsTarget(node, other, move(query, 4), metric(query, 5)));
            case "awayLast" -> code(game.getNextMoveAwayFromTarget(node, other, move(query, 4), metric(query, 5)));
            case "approxTowards" ->
                code(game.getApproximateNextMoveTowardsTarget(node, other, move(query, 4), metric(query, 5)));
            case "approxAway" ->
                code(game.getApproximateNextMoveAwayFromTarget(node, other, move(query, 4), metric(query, 5)));
            case "moves" -> codes(game.getPossibleMoves(node));
            case "movesLast" -> codes(game.getPossibleMoves(node, move(query, 3)));
            case "neighbours" -> game.getNeighbouringNodes(node);
            case "neighboursLast" -> game.getNeighbouringNodes(node, move(query, 3));
            case "neighbour" -> game.getNeighbour(node, move(query, 3));
            case "moveTo" -> code(game.getMoveToMakeToReachDirectNeighbour(node, other));
            case "closest" -> game.getClosestNodeIndexFromNodeIndex(node, nodes(query.get(3)), metric(query, 4));
            case "farthest" -> game.getFarthestNodeIndexFromNodeIndex(node, nodes(query.get(3)), metric(query, 4));
            case "node" ->
                new Object[] {
                    game.getNodeXCoord(node),
                    game.getNodeYCood(node),
                    game.getPillIndex(node),
                    game.getPowerPillIndex(node),
                    game.isJunction(node)
                };
            default -> throw new AssertionError("unknown query " + query);
        };
    }

    private static MOVE move(JsonNode query, int index) {
        return TracedGame.move(query.get(index).asText().charAt(0));
    }

    private static DM metric(JsonNode query, int index) {
        return DM.valueOf(query.get(index).asText());
    }

    private static String code(MOVE move) {
        return move == null ? "-" : move.name().substring(0, 1);
    }

    private static String codes(MOVE[] moves) {
        if (moves == null) {
            return null;
        }
        StringBuilder codes = new StringBuilder();
        for (MOVE move : moves) {
            codes.append(code(move));
        }
        return codes.toString();
    }

    static int[] nodes(JsonNode array) {
        return IntStream.range(0, array.size()).map(i -> array.get(i).asInt()).toArray();
    }
}
