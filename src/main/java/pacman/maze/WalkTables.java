package pacman.maze;

import java.util.ArrayList;
import java.util.List;

/**
 * All walks of a given number of steps that start in a direction and never turn back, and what they meet.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 4.7; the paper's "30 steps ahead".
 */
public final class WalkTables {

    /*
     * Of a walk only the set of pills on it matters: a bit mask. A walk whose pills all lie on another walk is left out. The
     * greatest number of junctions does not depend on the state at all.
     */

    /** The mazes of the competition have at most a few dozen from one node; a net of corridors could have millions. */
    private static final int MOST_WALKS = 20_000;

    /** Longs of one mask. */
    private final int words;

    /** Number of the first walk from node v in direction d, at index 4 v + d; the walks of the next index follow. */
    private final int[] first;

    /** Pills on each walk, {@link #words} longs each. */
    private final long[] masks;

    /** Most junctions on a walk from node v in direction d, at index 4 v + d. */
    private final byte[] junctions;

    /** Walks of so many steps in a maze. */
    public WalkTables(MazeGraph graph, int depth) {
        words = graph.pillWords();
        first = new int[4 * graph.nodeCount() + 1];
        junctions = new byte[4 * graph.nodeCount()];
        Explorer explorer = new Explorer(graph, depth, words);
        List<long[]> all = new ArrayList<>();
        for (int v = 0; v < graph.nodeCount(); v++) {
            for (int d = 0; d < 4; d++) {
                first[4 * v + d] = all.size();
                if (graph.neighbour(v, d) != CorridorPositions.NONE) {
                    explorer.explore(v, d);
                    junctions[4 * v + d] = (byte) explorer.mostJunctions;
                    all.addAll(explorer.walks);
                }
            }
        }
        first[4 * graph.nodeCount()] = all.size();
        masks = new long[all.size() * words];
        for (int i = 0; i < all.size(); i++) {
            System.arraycopy(all.get(i), 0, masks, i * words, words);
        }
    }

    /**
     * The most active pills on a walk.
     *
     * @param active bits of the active pills
     */
    public int mostPills(int node, int direction, long[] active) {
        int most = 0;
        int end = first[4 * node + direction + 1] * words;
        int at = first[4 * node + direction] * words;
        while (at < end) {
            int pills = 0;
            for (int word = 0; word < words; word++) {
                pills += Long.bitCount(masks[at++] & active[word]);
            }
            most = Math.max(most, pills);
        }
        return most;
    }

    /** The most junctions on a walk. */
    public int mostJunctions(int node, int direction) {
        return junctions[4 * node + direction];
    }

    /** Walks from one node in one direction; where a walk starts does not count, and no node counts twice. */
    private static final class Explorer {

        private final MazeGraph graph;
        private final int depth;
        private final int words;
        private final int[] visits;
        private int junctionsNow;
        private int mostJunctions;
        private List<long[]> walks;
        private int from;
        private int explored;

        private Explorer(MazeGraph graph, int depth, int words) {
            this.graph = graph;
            this.depth = depth;
            this.words = words;
            visits = new int[graph.nodeCount()];
        }

        private void explore(int start, int direction) {
            from = start;
            explored = 0;
            walks = new ArrayList<>();
            mostJunctions = 0;
            visits[start]++;
            step(graph.neighbour(start, direction), direction, depth, new long[words]);
            visits[start]--;
        }

        private void step(int node, int move, int stepsLeft, long[] pillsBefore) {
            if (stepsLeft == 0) {
                if (++explored > MOST_WALKS) {
                    throw new IllegalArgumentException(
                            "maze " + graph.name() + ": more than " + MOST_WALKS + " walks of "
                                    + depth + " steps start at node " + from
                                    + "; draw corridors farther apart or lower smallStepSimDepth");
                }
                mostJunctions = Math.max(mostJunctions, junctionsNow);
                keep(pillsBefore);
                return;
            }
            boolean isNew = visits[node]++ == 0;
            long[] pills = pillsBefore;
            if (isNew && graph.pillNumber(node) != CorridorPositions.NONE) {
                pills = pillsBefore.clone();
                pills[graph.pillNumber(node) >> 6] |= 1L << graph.pillNumber(node);
            }
            int counted = isNew && graph.isJunction(node) ? 1 : 0;
            junctionsNow += counted;
            for (int d = 0; d < 4; d++) {
                if (d != CorridorPositions.opposite(move) && graph.neighbour(node, d) != CorridorPositions.NONE) {
                    step(graph.neighbour(node, d), d, stepsLeft - 1, pills);
                }
            }
            junctionsNow -= counted;
            visits[node]--;
        }

        private void keep(long[] pills) {
            for (long[] other : walks) {
                if (isSubset(pills, other)) {
                    return;
                }
            }
            walks.removeIf(other -> isSubset(other, pills));
            walks.add(pills);
        }

        private static boolean isSubset(long[] inner, long[] outer) {
            for (int word = 0; word < inner.length; word++) {
                if ((inner[word] & ~outer[word]) != 0) {
                    return false;
                }
            }
            return true;
        }
    }
}
