package pacman.maze;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
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
     *
     * Walks that start alike meet pills in a few words of the bit set only: those are kept. Walks with more pills come first,
     * so that the search ends where no walk can have more pills than the best so far.
     */

    /** The mazes of the competition have at most a few dozen from one node; a net of corridors could have millions. */
    private static final int MOST_WALKS = 20_000;

    /** Number of the first walk from node v in direction d, at index 4 v + d; the walks of the next index follow. */
    private final int[] first;

    /** For the same index, the first and the number of the words that its walks' masks have. */
    private final byte[] firstWord;

    private final byte[] wordCount;

    /** For the same index, where its masks start. */
    private final int[] maskStart;

    /** Pills on each walk, as many longs as its index has words. */
    private final long[] masks;

    /** Number of pills on each walk, descending for each index. */
    private final byte[] sizes;

    /** Most junctions on a walk from node v in direction d, at index 4 v + d. */
    private final byte[] junctions;

    /** Walks of so many steps in a maze. */
    public WalkTables(MazeGraph graph, int depth) {
        int indices = 4 * graph.nodeCount();
        first = new int[indices + 1];
        maskStart = new int[indices];
        firstWord = new byte[indices];
        wordCount = new byte[indices];
        junctions = new byte[indices];
        Explorer explorer = new Explorer(graph, depth, graph.pillWords());
        List<Integer> allSizes = new ArrayList<>();
        List<Long> allMasks = new ArrayList<>();
        for (int index = 0; index < indices; index++) {
            first[index] = allSizes.size();
            maskStart[index] = allMasks.size();
            if (graph.neighbour(index >> 2, index & 3) != CorridorPositions.NONE) {
                explorer.explore(index >> 2, index & 3);
                junctions[index] = (byte) explorer.mostJunctions;
                explorer.walks.sort(Comparator.comparingInt(WalkTables::size).reversed());
                findWords(index, explorer.walks);
                for (long[] walk : explorer.walks) {
                    allSizes.add(size(walk));
                    for (int word = 0; word < wordCount[index]; word++) {
                        allMasks.add(walk[firstWord[index] + word]);
                    }
                }
            }
        }
        first[indices] = allSizes.size();
        masks = allMasks.stream().mapToLong(Long::longValue).toArray();
        sizes = new byte[allSizes.size()];
        for (int walk = 0; walk < sizes.length; walk++) {
            sizes[walk] = allSizes.get(walk).byteValue();
        }
    }

    private static int size(long[] walk) {
        return Arrays.stream(walk).mapToInt(Long::bitCount).sum();
    }

    /** Finds the words in which any of these walks has pills. */
    private void findWords(int index, List<long[]> walks) {
        int last = 0;
        int start = walks.get(0).length;
        for (long[] walk : walks) {
            for (int word = 0; word < walk.length; word++) {
                if (walk[word] != 0) {
                    start = Math.min(start, word);
                    last = Math.max(last, word + 1);
                }
            }
        }
        firstWord[index] = (byte) start;
        wordCount[index] = (byte) Math.max(last - start, 0);
    }

    /**
     * The most active pills on a walk.
     *
     * @param active bits of the active pills
     */
    public int mostPills(int node, int direction, long[] active) {
        int index = 4 * node + direction;
        int end = first[index + 1];
        int start = firstWord[index];
        int afterLast = start + wordCount[index];
        int at = maskStart[index];
        int most = 0;
        for (int walk = first[index]; walk < end && sizes[walk] > most; walk++) {
            int pills = 0;
            for (int word = start; word < afterLast; word++) {
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
