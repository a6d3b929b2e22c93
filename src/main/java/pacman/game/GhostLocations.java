package pacman.game;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.Reader;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import pacman.maze.Mazes;

/**
 * Recorded locations of the four ghosts when a power pill was eaten. Ghosts start there in the ghost-eating games of
 * the isolated task. Immutable.
 *
 * <p>The text has one observation per line, six whitespace-separated integers: maze, power pill, and the nodes of
 * Blinky, Pinky, Inky and Sue. The first {@value #SITUATIONS} lines of each maze and power pill are used. Every line is
 * checked.
 *
 * <p>Source: docs/specification/simulator.md, section 7 (database file).
 */
public final class GhostLocations {

    /** Number of observations used per maze and power pill. */
    public static final int SITUATIONS = 100;

    /** Power pills of each of the four mazes. */
    static final int POWER_PILLS = 4;

    /**
     * The shipped recording, from games of a champion that this program evolved; docs/champions.md describes how it was
     * made.
     */
    private static final String SHIPPED = "ghost-locations.txt";

    /** Nodes, index ((maze 4 + power pill) 100 + observation) 4 + ghost. */
    private final short[] nodes;

    private GhostLocations(short[] nodes) {
        this.nodes = nodes;
    }

    /** Returns the shipped recording. */
    public static GhostLocations shipped() {
        try {
            return read(SHIPPED, new StringReader(shippedText()));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Returns the text of the shipped recording. */
    public static String shippedText() {
        try (InputStream text = GhostLocations.class.getResourceAsStream(SHIPPED)) {
            return new String(text.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Reads a recording.
     *
     * @param source name for error messages
     * @throws IllegalArgumentException if a line is invalid, names a node where no ghost can be, or if a power pill has
     *     too few observations
     */
    public static GhostLocations read(String source, Reader text) throws IOException {
        short[] nodes = new short[Constants.NUM_MAZES * POWER_PILLS * SITUATIONS * Constants.NUM_GHOSTS];
        int[] counts = new int[Constants.NUM_MAZES * POWER_PILLS];
        BufferedReader lines = new BufferedReader(text);
        int number = 0;
        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
            number++;
            if (!line.isBlank()) {
                add(parse(line, source + ":" + number), counts, nodes);
            }
        }
        for (int key = 0; key < counts.length; key++) {
            if (counts[key] < SITUATIONS) {
                throw new IllegalArgumentException(source + ": maze " + key / POWER_PILLS + ", power pill "
                        + key % POWER_PILLS + " has " + counts[key] + " situations, " + SITUATIONS + " are needed");
            }
        }
        return new GhostLocations(nodes);
    }

    private static int[] parse(String line, String where) {
        try {
            int[] fields = Arrays.stream(line.trim().split("\\s+"))
                    .mapToInt(Integer::parseInt)
                    .toArray();
            if (fields.length == 2 + Constants.NUM_GHOSTS
                    && fields[0] >= 0
                    && fields[0] < Constants.NUM_MAZES
                    && fields[1] >= 0
                    && fields[1] < POWER_PILLS) {
                requireNodes(fields, where);
                return fields;
            }
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(where + ": not a number: " + line.trim(), e);
        }
        throw new IllegalArgumentException(
                where + ": expected six integers: maze 0 to 3, power pill 0 to 3 and four nodes");
    }

    private static void requireNodes(int[] fields, String where) {
        // The lair is the last node.
        int nodes = Mazes.standard().get(fields[0]).graph().lair();
        for (int ghost = 0; ghost < Constants.NUM_GHOSTS; ghost++) {
            int node = fields[2 + ghost];
            if (node < 0 || node >= nodes) {
                throw new IllegalArgumentException(where + ": node " + node + " is not in maze " + fields[0]
                        + ", whose corridors have the nodes 0 to " + (nodes - 1));
            }
        }
    }

    private static void add(int[] fields, int[] counts, short[] nodes) {
        int key = fields[0] * POWER_PILLS + fields[1];
        if (counts[key] == SITUATIONS) {
            return;
        }
        for (int ghost = 0; ghost < Constants.NUM_GHOSTS; ghost++) {
            nodes[(key * SITUATIONS + counts[key]) * Constants.NUM_GHOSTS + ghost] = (short) fields[2 + ghost];
        }
        counts[key]++;
    }

    /** Node of a ghost in one of the {@value #SITUATIONS} observations of a maze and a power pill. */
    int node(int maze, int powerPill, int observation, int ghost) {
        return nodes[((maze * POWER_PILLS + powerPill) * SITUATIONS + observation) * Constants.NUM_GHOSTS + ghost];
    }

    /** Whether the recordings have the same observations. */
    @Override
    public boolean equals(Object other) {
        return other instanceof GhostLocations locations && Arrays.equals(nodes, locations.nodes);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(nodes);
    }
}
