package pacman.maze;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.IntStream;
import pacman.game.Constants.MOVE;
import pacman.game.internal.Maze;
import pacman.game.internal.Node;

/** A text with all data of a maze, from our maze or from the original's record of it. */
public final class MazeText {

    /** The file of the compact data with the digest of each maze's text. */
    public static final String DIGESTS = "digests.properties";

    private static final List<String> FIELDS =
            List.of("index", "x", "y", "up", "right", "down", "left", "pill", "powerPill");

    private MazeText() {}

    /** The text of a maze file of the golden data. */
    public static String of(Path json) throws IOException {
        JsonNode maze = new ObjectMapper().readTree(json.toFile());
        StringBuilder text = new StringBuilder(maze.get("name").asText()).append('\n');
        for (String field : List.of("initialPacManNodeIndex", "lairNodeIndex", "initialGhostNodeIndex")) {
            text.append(maze.get(field).asInt()).append('\n');
        }
        for (String field : List.of(
                "pillIndices", "powerPillIndices", "junctionIndices", "pillIndexNumbersRemovedNearPowerPills")) {
            text.append(maze.get(field)).append('\n');
        }
        for (JsonNode node : maze.get("nodes")) {
            int[] fields =
                    FIELDS.stream().mapToInt(field -> node.get(field).asInt()).toArray();
            text.append(Arrays.toString(fields)).append('\n');
        }
        return text.toString().replace(" ", "");
    }

    static String of(Maze maze) {
        StringBuilder text = new StringBuilder(maze.name).append('\n');
        for (int node : List.of(maze.initialPacManNodeIndex, maze.lairNodeIndex, maze.initialGhostNodeIndex)) {
            text.append(node).append('\n');
        }
        MazeGraph graph = Mazes.standard().get("abcd".indexOf(maze.name)).graph();
        int[] removed = IntStream.range(0, graph.pillCount())
                .filter(pill -> (graph.pillsNearPowerPills(pill >> 6) >>> pill & 1) != 0)
                .toArray();
        for (int[] list : List.of(maze.pillIndices, maze.powerPillIndices, maze.junctionIndices, removed)) {
            text.append(Arrays.toString(list)).append('\n');
        }
        for (Node node : maze.graph) {
            int[] fields = {
                node.nodeIndex,
                node.x,
                node.y,
                node.neighbourhood.getOrDefault(MOVE.UP, -1),
                node.neighbourhood.getOrDefault(MOVE.RIGHT, -1),
                node.neighbourhood.getOrDefault(MOVE.DOWN, -1),
                node.neighbourhood.getOrDefault(MOVE.LEFT, -1),
                node.pillIndex,
                node.powerPillIndex
            };
            text.append(Arrays.toString(fields)).append('\n');
        }
        return text.toString().replace(" ", "");
    }

    /** The SHA-256 of a text, in hexadecimal. */
    public static String digest(String text) {
        try {
            MessageDigest sha = MessageDigest.getInstance("SHA-256");
            return HexFormat.of().formatHex(sha.digest(text.getBytes(StandardCharsets.UTF_8)));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
