package pacman.game;

import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.Predicate;

/**
 * The text of a recording of ghost locations in which single locations can be blanked, to find those that given games
 * use.
 *
 * <p>It contains only the observations that are used, {@value GhostLocations#SITUATIONS} per maze and power pill. A
 * blank location is node 0.
 */
public final class GhostPlaces {

    private static final int KEYS = Constants.NUM_MAZES * GhostLocations.POWER_PILLS;

    private final int[] nodes = new int[KEYS * GhostLocations.SITUATIONS * Constants.NUM_GHOSTS];
    private final BitSet used = new BitSet();

    /** Reads the original's file. */
    public GhostPlaces(Path file) throws IOException {
        int[] counts = new int[KEYS];
        for (String line : Files.readAllLines(file)) {
            int[] fields = Arrays.stream(line.trim().split("\\s+"))
                    .mapToInt(Integer::parseInt)
                    .toArray();
            int key = fields[0] * GhostLocations.POWER_PILLS + fields[1];
            if (counts[key] < GhostLocations.SITUATIONS) {
                int row = key * GhostLocations.SITUATIONS + counts[key]++;
                System.arraycopy(fields, 2, nodes, row * Constants.NUM_GHOSTS, Constants.NUM_GHOSTS);
            }
        }
    }

    /**
     * Marks the locations that a game or an evaluation needs.
     *
     * @param isRight whether the outcome with the given locations equals the recorded one
     */
    public void mark(Predicate<GhostLocations> isRight) {
        BitSet kept = new BitSet();
        kept.set(0, nodes.length);
        if (!isRight.test(locations(kept))) {
            throw new IllegalStateException("the recorded outcome is not reached even with all places");
        }
        blank(kept, 0, nodes.length, isRight);
        used.or(kept);
    }

    private void blank(BitSet kept, int from, int to, Predicate<GhostLocations> isRight) {
        kept.clear(from, to);
        if (!isRight.test(locations(kept))) {
            kept.set(from, to);
            if (to - from > 1) {
                int middle = (from + to) >>> 1;
                blank(kept, from, middle, isRight);
                blank(kept, middle, to, isRight);
            }
        }
    }

    /** Returns the number of marked locations. */
    public int marked() {
        return used.cardinality();
    }

    /** Writes the marked locations; all others are blank. */
    public void write(Path file) throws IOException {
        Files.writeString(file, text(used));
    }

    private GhostLocations locations(BitSet kept) {
        try {
            return GhostLocations.read("places", new StringReader(text(kept)));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private String text(BitSet kept) {
        StringBuilder text = new StringBuilder(1 << 15);
        for (int row = 0; row < KEYS * GhostLocations.SITUATIONS; row++) {
            int key = row / GhostLocations.SITUATIONS;
            text.append(key / GhostLocations.POWER_PILLS).append('\t').append(key % GhostLocations.POWER_PILLS);
            for (int ghost = 0; ghost < Constants.NUM_GHOSTS; ghost++) {
                int place = row * Constants.NUM_GHOSTS + ghost;
                text.append('\t').append(kept.get(place) ? nodes[place] : 0);
            }
            text.append('\n');
        }
        return text.toString();
    }

    /** Marks the locations that the given games of a full trace file need. */
    public void markGames(Path trace, java.util.function.IntPredicate keeps) throws IOException {
        for (List<String> game : CompactTraces.games(trace, keeps)) {
            mark(locations -> {
                try {
                    TraceReplay replay = new TraceReplay("trace", locations);
                    for (String line : game) {
                        replay.replay(line);
                    }
                    return true;
                } catch (AssertionError wrong) {
                    return false;
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            });
        }
    }

    /** Marks the locations that a scripted run of the engine needs. */
    public void markEngineRun(int corner) {
        mark(locations -> {
            try {
                return EngineRunConformanceTest.isTheOriginals(
                        "isolated-ghost-" + corner, 14 + corner, 1, GameRules.isolatedGhosts(corner, locations));
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        });
    }
}
