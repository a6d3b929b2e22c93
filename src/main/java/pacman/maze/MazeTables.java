package pacman.maze;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/**
 * A maze and everything that is known about it in advance. Immutable, shared by any number of games and threads; the
 * larger tables are computed on the first request.
 */
public final class MazeTables {

    private final MazeGraph graph;
    private final MazePoses poses;

    /*
     * Each is made once under the lock. The objects are immutable with final fields, or written before they are
     * published through the volatile field.
     */
    private volatile @Nullable MazeDistances distances;
    private volatile @Nullable MazePaths paths;
    private volatile @Nullable PillOrder pillOrder;

    private final Map<Object, Object> derived = new ConcurrentHashMap<>();

    private MazeTables(MazeGraph graph) {
        this.graph = graph;
        poses = new MazePoses(graph);
    }

    /**
     * Returns an object that depends on the maze alone. It is computed on the first request and shared from then on.
     *
     * @param key identifies the object by {@code equals} and {@code hashCode}; use a record of the class that asks
     * @param maker computes the object; it must not call {@code derived} of the same maze
     * @param type type of the object
     */
    public <T> T derived(Object key, Function<MazeTables, T> maker, Class<T> type) {
        Object known = derived.get(key);
        return type.cast(known != null ? known : derived.computeIfAbsent(key, missing -> maker.apply(this)));
    }

    /**
     * Reads a drawing from a file.
     *
     * @throws MazeFormatException if the drawing cannot be played
     * @throws IOException if the file cannot be read
     */
    public static MazeTables read(Path file) throws IOException {
        // Some editors put a mark in front of texts in UTF-8.
        return parse(file.toString(), Files.readString(file).replaceFirst("^\uFEFF", ""));
    }

    /**
     * Reads a drawing from a text.
     *
     * @param file name for error messages, and of the maze
     * @throws MazeFormatException if the drawing cannot be played
     */
    public static MazeTables parse(String file, String drawing) {
        return new MazeTables(new MazeGraph(file, new MazeDrawing(file, drawing)));
    }

    static MazeTables standard(String letter) {
        String file = "mazes/" + letter + ".txt";
        try (InputStream in = MazeTables.class.getResourceAsStream("/" + file)) {
            if (in == null) {
                throw new IllegalStateException("the maze drawing " + file + " is missing from the jar");
            }
            String drawing = new String(in.readAllBytes(), StandardCharsets.UTF_8);
            return new MazeTables(new MazeGraph(letter, new MazeDrawing(file, drawing)));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public MazeGraph graph() {
        return graph;
    }

    /** The table of the steps of ghosts and Ms. Pac-Man. */
    public MazePoses poses() {
        return poses;
    }

    /** Distances between all nodes. */
    public MazeDistances distances() {
        MazeDistances known = distances;
        return known != null ? known : makeDistances();
    }

    private synchronized MazeDistances makeDistances() {
        if (distances == null) {
            distances = new MazeDistances(graph);
        }
        return distances;
    }

    /** The simulator's paths. */
    public MazePaths paths() {
        MazePaths known = paths;
        return known != null ? known : makePaths();
    }

    private synchronized MazePaths makePaths() {
        if (paths == null) {
            paths = new MazePaths(graph, distances(), new Corridors(graph));
        }
        return paths;
    }

    /** Pills in the order of their distance from each node. */
    public PillOrder pillOrder() {
        PillOrder known = pillOrder;
        return known != null ? known : makePillOrder();
    }

    private synchronized PillOrder makePillOrder() {
        if (pillOrder == null) {
            pillOrder = new PillOrder(graph, distances());
        }
        return pillOrder;
    }

    /** Computes the tables that are otherwise computed on their first request. */
    public void prepare() {
        paths();
        pillOrder();
    }
}
