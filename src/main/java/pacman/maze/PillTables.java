package pacman.maze;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * In which order pills are met from a node in a direction.
 *
 * <p>The nearest pill in a direction is the first active one in the corridor ahead, else the first active one in the order of
 * the row that continues from the junction at its end (nearest first, then by pill number, as the simulator prefers them).
 */
public final class PillTables {

    private final int[] pillNodes;

    /** Pills in the corridor ahead of node v in direction d, nearest first, at index 4 v + d: position in {@link #ahead}. */
    private final int[] aheadFrom;

    /** Steps to a pill ahead in the upper half, its number in the lower half. */
    private final int[] ahead;

    /** Pills in the order of row r, at index pills r + rank. */
    private final short[] order;

    public PillTables(MazeGraph graph, Routes routes, PathTables paths) {
        pillNodes = IntStream.range(0, graph.pillCount()).map(graph::pillNode).toArray();
        aheadFrom = new int[4 * graph.nodeCount() + 1];
        List<Integer> entries = new ArrayList<>();
        for (int v = 0; v < graph.nodeCount(); v++) {
            for (int d = 0; d < 4; d++) {
                aheadFrom[4 * v + d] = entries.size();
                if (graph.neighbour(v, d) != CorridorPositions.NONE) {
                    addPillsAhead(graph, v, d, entries);
                }
            }
        }
        aheadFrom[4 * graph.nodeCount()] = entries.size();
        ahead = entries.stream().mapToInt(Integer::intValue).toArray();
        order = new short[routes.rowCount() * pillNodes.length];
        for (int row = 0; row < routes.rowCount(); row++) {
            int r = row;
            int[] sorted = IntStream.range(0, pillNodes.length)
                    .boxed()
                    .sorted(Comparator.comparingInt(pill -> paths.rowLength(r, pillNodes[pill])))
                    .mapToInt(Integer::intValue)
                    .toArray();
            for (int rank = 0; rank < sorted.length; rank++) {
                order[row * pillNodes.length + rank] = (short) sorted[rank];
            }
        }
    }

    private static void addPillsAhead(MazeGraph graph, int from, int direction, List<Integer> entries) {
        int move = direction;
        int node = graph.neighbour(from, direction);
        for (int steps = 1; ; steps++) {
            if (graph.pillNumber(node) != CorridorPositions.NONE) {
                entries.add(steps << 16 | graph.pillNumber(node));
            }
            if (graph.isJunction(node)) {
                return;
            }
            move = CorridorPositions.onward(graph, node, move);
            node = graph.neighbour(node, move);
        }
    }

    /**
     * Steps to the first active pill in the corridor ahead, its junction included.
     *
     * @param active bits of the active pills
     * @return 0 if there is none
     */
    public int stepsToPillAhead(int node, int direction, long[] active) {
        for (int i = aheadFrom[4 * node + direction]; i < aheadFrom[4 * node + direction + 1]; i++) {
            int pill = ahead[i] & 0xFFFF;
            if ((active[pill >> 6] >>> pill & 1) != 0) {
                return ahead[i] >> 16;
            }
        }
        return 0;
    }

    /**
     * Rank in a row's order of the first active pill.
     *
     * @param rank where to start: no pill before it is active
     * @param active bits of the active pills; at least one
     */
    public int firstActive(int row, int rank, long[] active) {
        int base = row * pillNodes.length;
        int at = rank;
        while ((active[order[base + at] >> 6] >>> order[base + at] & 1) == 0) {
            at++;
        }
        return at;
    }

    /** Node of the pill with a rank in a row's order. */
    public int node(int row, int rank) {
        return pillNodes[order[row * pillNodes.length + rank]];
    }
}
