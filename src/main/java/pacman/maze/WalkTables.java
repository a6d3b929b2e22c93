package pacman.maze;

import java.nio.LongBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * All walks of a given number of steps that start in a direction and never turn back, and what they meet.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 4.7; the paper's "30 steps ahead".
 */
public final class WalkTables {

    /*
     * Of a walk only the set of pills on it matters: a bit mask. A walk whose pills all lie on another walk is left
     * out. The greatest number of junctions does not depend on the state at all.
     *
     * Walks that start alike meet pills in a few words of the bit set only: those are kept. Walks with more pills come
     * first, so that the search ends where no walk can have more pills than the best so far.
     */

    /** The mazes of the competition have at most a few dozen from one node; a net of corridors could have millions. */
    private static final int MOST_WALKS = 20_000;

    /** List of the walks from node v in direction d, at index 4 v + d. Lists with the same pills are kept once. */
    private final int[] lists;

    /** Number of the first walk of each list; the walks of the next list follow. */
    private final int[] first;

    /** Per list, the first word that its masks have, and the word after the last. */
    private final byte[] firstWord;

    private final byte[] endWord;

    /** Per list, where its masks start. */
    private final int[] maskStart;

    /** Pills on each walk, as many longs as its list has words. */
    private final long[] masks;

    /** Number of pills on each walk, descending within a list. */
    private final byte[] sizes;

    /** Most junctions on a walk from node v in direction d, at index 4 v + d. */
    private final byte[] junctions;

    /**
     * Finds the walks of a maze.
     *
     * @param depth number of steps of a walk
     * @throws IllegalArgumentException if too many walks start at one node
     */
    public WalkTables(MazeGraph graph, int depth) {
        lists = new int[4 * graph.nodeCount()];
        junctions = new byte[lists.length];
        Explorer explorer = new Explorer(graph, depth, graph.pillWords());
        Map<List<LongBuffer>, Integer> numbers = new LinkedHashMap<>();
        for (int index = 0; index < lists.length; index++) {
            if (graph.neighbour(index >> 2, index & 3) != MazeGraph.NONE) {
                explorer.explore(index >> 2, index & 3);
                junctions[index] = (byte) explorer.mostJunctions;
                explorer.walks.sort(Comparator.comparingInt(WalkTables::size).reversed());
                List<LongBuffer> walks =
                        explorer.walks.stream().map(LongBuffer::wrap).toList();
                numbers.putIfAbsent(walks, numbers.size());
                lists[index] = numbers.get(walks);
            }
        }
        first = new int[numbers.size() + 1];
        maskStart = new int[numbers.size()];
        firstWord = new byte[numbers.size()];
        endWord = new byte[numbers.size()];
        sizes = new byte[numbers.keySet().stream().mapToInt(List::size).sum()];
        long[] found = new long[sizes.length * graph.pillWords()];
        int count = 0;
        int list = 0;
        for (List<LongBuffer> walks : numbers.keySet()) {
            findWords(list, walks);
            maskStart[list] = count;
            first[list + 1] = first[list];
            for (LongBuffer walk : walks) {
                sizes[first[list + 1]++] = (byte) size(walk.array());
                for (int word = firstWord[list]; word < endWord[list]; word++) {
                    found[count++] = walk.get(word);
                }
            }
            list++;
        }
        masks = Arrays.copyOf(found, count);
    }

    private static int size(long[] walk) {
        return Arrays.stream(walk).mapToInt(Long::bitCount).sum();
    }

    /** Finds the words in which any of a list's walks has pills. */
    private void findWords(int list, List<LongBuffer> walks) {
        int words = walks.get(0).capacity();
        int start = words;
        int end = 0;
        for (LongBuffer walk : walks) {
            for (int word = 0; word < words; word++) {
                if (walk.get(word) != 0) {
                    start = Math.min(start, word);
                    end = Math.max(end, word + 1);
                }
            }
        }
        firstWord[list] = (byte) start;
        endWord[list] = (byte) end;
    }

    /**
     * Identifier of the list of walks that start at a node in a direction, for {@link #mostPills}. Neighbouring nodes
     * often share a list; a caller may then reuse the answer that it has for the list.
     */
    public int list(int node, int direction) {
        return lists[4 * node + direction];
    }

    /**
     * Largest number of active pills on one walk of a list.
     *
     * @param list identifier from {@link #list}
     * @param active bit set of the pills that are not eaten
     */
    public int mostPills(int list, long[] active) {
        int end = first[list + 1];
        int start = firstWord[list];
        int afterLast = endWord[list];
        int at = maskStart[list];
        int most = 0;
        for (int walk = first[list]; walk < end && sizes[walk] > most; walk++) {
            int pills = 0;
            for (int word = start; word < afterLast; word++) {
                pills += Long.bitCount(masks[at++] & active[word]);
            }
            most = Math.max(most, pills);
        }
        return most;
    }

    /** Largest number of junctions on one walk from a node in a direction. It does not depend on the pills. */
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
        private List<long[]> walks = new ArrayList<>();
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
            if (isNew && graph.pillNumber(node) != MazeGraph.NONE) {
                pills = pillsBefore.clone();
                pills[graph.pillNumber(node) >> 6] |= 1L << graph.pillNumber(node);
            }
            int counted = isNew && graph.isJunction(node) ? 1 : 0;
            junctionsNow += counted;
            for (int d = 0; d < 4; d++) {
                if (d != MazeGraph.opposite(move) && graph.neighbour(node, d) != MazeGraph.NONE) {
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
