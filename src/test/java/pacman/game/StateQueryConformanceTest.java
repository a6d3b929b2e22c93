package pacman.game;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import java.util.zip.GZIPInputStream;
import mmneat.GoldenData;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;

/** Queries of game states give the original's results, computed from the engine's primitives. */
@Tag("conformance")
class StateQueryConformanceTest {

    private static final ObjectMapper JSON = new ObjectMapper();

    private Game game;
    private int pacMan;

    @Test
    void queries_haveTheOriginalsAnswers() throws IOException {
        int queries = 0;
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(
                        Files.newInputStream(GoldenData.folder("traces").resolve("queries-state.jsonl.gz"))),
                StandardCharsets.UTF_8))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                JsonNode query = JSON.readTree(line);
                if (!query.isObject()) {
                    queries++;
                    assertThat(JSON.valueToTree(answer(query)).toString())
                            .as(line)
                            .isEqualTo(query.get(query.size() - 1).toString());
                } else if (query.get("type").asText().equals("state")) {
                    game = new Game(0, GameRules.blended());
                    game.setGameState(query.get("state").asText());
                    assertThat(game.getGameState()).isEqualTo(query.get("state").asText());
                    pacMan = game.getPacmanCurrentNodeIndex();
                }
            }
        }
        assertThat(queries).isEqualTo(18_424);
    }

    private Object answer(JsonNode query) {
        String name = query.get(0).asText();
        int first = query.size() > 2 ? query.get(1).asInt() : -1;
        int second = query.size() > 3 ? query.get(2).asInt() : -1;
        return switch (name) {
            case "requires" -> flags(ghost -> game.doesGhostRequireAction(GHOST.values()[ghost]));
            case "edible" -> flags(this::isEdible);
            case "activePills" -> game.getActivePillsIndices();
            case "activePowerPills" -> game.getActivePowerPillsIndices();
            case "counts" ->
                new int[] {
                    game.getNumberOfActivePills(),
                    game.getNumberOfActivePowerPills(),
                    game.getNumberOfPills(),
                    game.getNumberOfPowerPills(),
                    game.getNumberOfNodes(),
                    game.getNumGhostsEaten(),
                    game.getNumEdibleGhosts(),
                    game.newEdibleTime(),
                    game.levelTimeLeft()
                };
            case "closestPill" -> closest(game.getActivePillsIndices(), query);
            case "closestJunction" -> closest(game.getJunctionIndices(), query);
            case "farthestPill" ->
                game.getFarthestNodeIndexFromNodeIndex(
                        pacMan,
                        game.getActivePillsIndices(),
                        DM.valueOf(query.get(1).asText()));
            case "threats" -> game.getThreatGhostLocations();
            case "edibles" -> nodes(this::isEdible);
            case "activeGhosts" -> nodes(this::isActive);
            case "approaching" -> approaches(first);
            case "approachingThreats" -> nodes(ghost -> game.isGhostThreat(ghost) && approaches(ghost));
            case "approachingEdibles" -> nodes(ghost -> isEdible(ghost) && approaches(ghost));
            case "incoming" -> comesThrough(second, first);
            case "incomingThreats" -> nodes(ghost -> game.isGhostThreat(ghost) && comesThrough(ghost, first));
            case "incomingEdibles" -> nodes(ghost -> isEdible(ghost) && comesThrough(ghost, first));
            case "trapped" ->
                Arrays.stream(directionalPath(pacMan, game.ghostNode(second), first))
                        .noneMatch(game::isJunction);
            case "ghostPath" -> ghostPath(first, second);
            case "ghostPathDistance" ->
                Double.toString(game.getDistance(game.ghostNode(first), second, lastMove(first), DM.PATH));
            case "ghostTravelTime" -> travelTime(first, second);
            case "edibleAfterTravel" -> game.ghostEdibleTime(first) > travelTime(first, second);
            case "dirPath" -> directionalPath(pacMan, second, first);
            case "nearestPillInDir" -> nearest(game.getActivePillsIndices(), first);
            case "nearestPowerPillInDir" -> nearest(game.getActivePowerPillsIndices(), first);
            case "nearestJunctionInDir" -> nearest(game.getJunctionIndices(), first);
            case "farthestPillInDir" -> farthest(game.getActivePillsIndices(), first);
            case "nextJunction" -> nextJunction(first, second == 1);
            case "lairTimes" -> IntStream.range(0, 4).map(game::ghostLairTime).toArray();
            case "edibleTimes" ->
                IntStream.range(0, 4).map(game::ghostEdibleTime).toArray();
            case "untilLairExit" ->
                IntStream.range(0, 4)
                        .map(game::ghostLairTime)
                        .filter(time -> time > 0)
                        .min()
                        .orElse(-1);
            default -> throw new AssertionError("unknown query " + query);
        };
    }

    private static String flags(IntPredicate ofGhost) {
        StringBuilder flags = new StringBuilder();
        for (int ghost = 0; ghost < 4; ghost++) {
            flags.append(ofGhost.test(ghost) ? '1' : '0');
        }
        return flags.toString();
    }

    private int[] nodes(IntPredicate ofGhost) {
        return IntStream.range(0, 4).filter(ofGhost).map(game::ghostNode).toArray();
    }

    private boolean isEdible(int ghost) {
        return game.isGhostEdible(GHOST.values()[ghost]);
    }

    private boolean isActive(int ghost) {
        return game.getNeighbouringNodes(game.ghostNode(ghost)).length > 0;
    }

    private int closest(int[] targets, JsonNode query) {
        return game.getClosestNodeIndexFromNodeIndex(
                pacMan, targets, DM.valueOf(query.get(1).asText()));
    }

    private MOVE lastMove(int ghost) {
        return MOVE.values()[game.ghostLastMove(ghost)];
    }

    private int[] ghostPath(int ghost, int target) {
        return game.getShortestPath(game.ghostNode(ghost), target, lastMove(ghost));
    }

    private boolean approaches(int ghost) {
        return isActive(ghost)
                && ghostPath(ghost, pacMan).length == game.getShortestPath(game.ghostNode(ghost), pacMan).length;
    }

    private boolean comesThrough(int ghost, int direction) {
        int neighbour = game.mazeTables().graph().neighbour(pacMan, direction);
        return isActive(ghost) && Arrays.stream(ghostPath(ghost, pacMan)).anyMatch(node -> node == neighbour);
    }

    private int travelTime(int ghost, int target) {
        int distance = ghostPath(ghost, target).length;
        int edible = Math.min(game.ghostEdibleTime(ghost), 2 * distance);
        return distance + edible - edible / 2;
    }

    private int[] directionalPath(int from, int to, int direction) {
        MOVE move = MOVE.values()[direction];
        var graph = game.mazeTables().graph();
        boolean betweenWalls =
                graph.neighbour(from, (direction + 3) % 4) < 0 && graph.neighbour(from, (direction + 1) % 4) < 0;
        if (betweenWalls) {
            return game.getShortestPath(from, to, move);
        }
        int next = graph.neighbour(from, direction);
        return IntStream.concat(IntStream.of(next), Arrays.stream(game.getShortestPath(next, to, move)))
                .toArray();
    }

    private Object nearest(int[] targets, int direction) {
        return extreme(targets, direction, -1);
    }

    private Object farthest(int[] targets, int direction) {
        return extreme(targets, direction, 1);
    }

    private Object extreme(int[] targets, int direction, int sign) {
        int best = -1;
        int[] bestPath = null;
        for (int target : targets) {
            int[] path = directionalPath(pacMan, target, direction);
            if (bestPath == null || sign * path.length > sign * bestPath.length) {
                best = target;
                bestPath = path;
            }
        }
        return bestPath == null ? null : new Object[] {best, bestPath};
    }

    private int nextJunction(int direction, boolean powerPillsCount) {
        var graph = game.mazeTables().graph();
        int move = direction;
        int node = graph.neighbour(pacMan, move);
        while (!graph.isJunction(node) && !(powerPillsCount && hasPowerPill(node))) {
            int back = move ^ 2;
            move = 0;
            while (move == back || graph.neighbour(node, move) < 0) {
                move++;
            }
            node = graph.neighbour(node, move);
        }
        return node;
    }

    private boolean hasPowerPill(int node) {
        int powerPill = game.getPowerPillIndex(node);
        return powerPill >= 0 && game.isPowerPillStillAvailable(powerPill);
    }
}
