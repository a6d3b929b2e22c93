package pacman.maze;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The pills, or the power pills, of a maze in the order in which a walker meets them from a node in a direction. A pill
 * is active while it has not been eaten.
 *
 * <p>The nearest pill in a direction is the first active one in the corridor ahead. If that corridor has none, it is
 * the first active one in the order of a row. A row is a pair of a junction and the move that enters it, as in {@link
 * Routes}; here it is the junction at the end of the corridor. Its order is nearest first, then by pill number, as the
 * simulator prefers them.
 */
public final class PillTables {

    private final int[] pillNodes;

    /**
     * Pills in the corridor ahead of node v in direction d, nearest first, at index 4 v + d: position in {@link
     * #ahead}.
     */
    private final int[] aheadFrom;

    /** Steps to a pill ahead in the upper half, its number in the lower half. */
    private final int[] ahead;

    /**
     * Pills in the order of row r, at index pills r + rank: steps from the row's junction, and number, as in {@link
     * #ahead}.
     */
    private final int[] order;

    /** Number of the pill on each node, or -1. */
    private final short[] numbers;

    /** The order of a maze's pills. */
    public static PillTables ofPills(MazeGraph graph, MazePaths paths) {
        return new PillTables(graph, graph.pillNodes(), paths);
    }

    /** The order of a maze's power pills. */
    public static PillTables ofPowerPills(MazeGraph graph, MazePaths paths) {
        return new PillTables(graph, graph.powerPillNodes(), paths);
    }

    private PillTables(MazeGraph graph, int[] pillNodes, MazePaths paths) {
        this.pillNodes = pillNodes;
        numbers = new short[graph.nodeCount()];
        Arrays.fill(numbers, (short) MazeGraph.NONE);
        for (int pill = 0; pill < pillNodes.length; pill++) {
            numbers[pillNodes[pill]] = (short) pill;
        }
        aheadFrom = new int[4 * graph.nodeCount() + 1];
        List<Integer> entries = new ArrayList<>();
        for (int v = 0; v < graph.nodeCount(); v++) {
            for (int d = 0; d < 4; d++) {
                aheadFrom[4 * v + d] = entries.size();
                if (graph.neighbour(v, d) != MazeGraph.NONE) {
                    addPillsAhead(graph, v, d, entries);
                }
            }
        }
        aheadFrom[4 * graph.nodeCount()] = entries.size();
        ahead = entries.stream().mapToInt(Integer::intValue).toArray();
        int rows = paths.routes().rowCount();
        order = new int[rows * pillNodes.length];
        for (int row = 0; row < rows; row++) {
            for (int pill = 0; pill < pillNodes.length; pill++) {
                order[row * pillNodes.length + pill] = paths.rowLength(row, pillNodes[pill]) << 16 | pill;
            }
            Arrays.sort(order, row * pillNodes.length, (row + 1) * pillNodes.length);
        }
    }

    private void addPillsAhead(MazeGraph graph, int from, int direction, List<Integer> entries) {
        int move = direction;
        int node = graph.neighbour(from, direction);
        for (int steps = 1; ; steps++) {
            if (numbers[node] != MazeGraph.NONE) {
                entries.add(steps << 16 | numbers[node]);
            }
            if (graph.isJunction(node)) {
                return;
            }
            move = graph.onlyWayOn(node, move);
            node = graph.neighbour(node, move);
        }
    }

    /**
     * The first active pill in the corridor ahead, its junction included.
     *
     * @param active bits of the active pills
     * @return steps and pill, for {@link #stepsOf} and {@link #pillOf}; 0 if there is none
     */
    public int firstAhead(int node, int direction, long[] active) {
        for (int i = aheadFrom[4 * node + direction]; i < aheadFrom[4 * node + direction + 1]; i++) {
            if (isActive(pillOf(ahead[i]), active)) {
                return ahead[i];
            }
        }
        return 0;
    }

    /** Whether the pill on a node is there and active. */
    public boolean isActiveAt(int node, long[] active) {
        int pill = numbers[node];
        return pill >= 0 && isActive(pill, active);
    }

    /** Whether a pill is active. */
    public static boolean isActive(int pill, long[] active) {
        return (active[pill >> 6] >>> pill & 1) != 0;
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
        while (!isActive(pillOf(order[base + at]), active)) {
            at++;
        }
        return at;
    }

    /** Steps from a row's junction, and number, of the pill with a rank in its order. */
    public int ranked(int row, int rank) {
        return order[row * pillNodes.length + rank];
    }

    /** The steps in an answer. */
    public static int stepsOf(int answer) {
        return answer >> 16;
    }

    /** The number of the pill in an answer. */
    public static int pillOf(int answer) {
        return answer & 0xFFFF;
    }
}
