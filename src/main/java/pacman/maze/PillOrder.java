package pacman.maze;

/**
 * Finds the nearest pill or power pill that is present, from any node of a maze. Immutable.
 *
 * <p>Distances are path distances; of equally near ones a pill comes before a power pill, and then the lower number.
 */
public final class PillOrder {

    /*
     * For each node all pills and power pills are sorted by distance, once: the nearest one present is the first in
     * that row that has not been eaten. Late in a level most of a row is eaten; then the few that are left are compared
     * by distance instead. Two bytes per entry, 0.6 MB per maze.
     */

    /** With fewer pills than this they are compared one by one. */
    private static final int FEW = 24;

    private final MazeGraph graph;
    private final MazeDistances distances;

    /** Pills and power pills of the maze together. */
    private final int count;

    /** Row of count numbers per node: a pill's number, or the number of pills plus a power pill's number. */
    private final char[] order;

    PillOrder(MazeGraph graph, MazeDistances distances) {
        this.graph = graph;
        this.distances = distances;
        count = graph.pillCount() + graph.powerPillCount();
        order = new char[graph.nodeCount() * count];
        int[] starts = new int[graph.nodeCount() + 2];
        for (int node = 0; node < graph.nodeCount(); node++) {
            sortRow(node, starts);
        }
    }

    /** Counting sort, which keeps the order of equals; distances are below the number of nodes, and -1 in the lair. */
    private void sortRow(int node, int[] starts) {
        java.util.Arrays.fill(starts, 0);
        for (int number = 0; number < count; number++) {
            starts[distance(node, number) + 2]++;
        }
        for (int key = 1; key < starts.length; key++) {
            starts[key] += starts[key - 1];
        }
        for (int number = 0; number < count; number++) {
            order[node * count + starts[distance(node, number) + 1]++] = (char) number;
        }
    }

    private int distance(int node, int number) {
        return distances.between(target(number), node);
    }

    private int target(int number) {
        return number < graph.pillCount() ? graph.pillNode(number) : graph.powerPillNode(number - graph.pillCount());
    }

    /**
     * The node of the nearest pill or power pill that is present.
     *
     * @param node where to start from
     * @param pills bit set of the pills present
     * @param pillsLeft their number
     * @param powerPills bit set of the power pills present
     * @return -1 if nothing is present
     */
    public int nearest(int node, long[] pills, int pillsLeft, long powerPills) {
        return pillsLeft < FEW ? nearestOfFew(node, pills, powerPills) : nearestInOrder(node, pills, powerPills);
    }

    private int nearestInOrder(int node, long[] pills, long powerPills) {
        int pillCount = graph.pillCount();
        int end = (node + 1) * count;
        for (int entry = node * count; entry < end; entry++) {
            int number = order[entry];
            long bits =
                    number < pillCount ? pills[number >>> 6] >>> (number & 63) : powerPills >>> (number - pillCount);
            if ((bits & 1) != 0) {
                return target(number);
            }
        }
        return -1;
    }

    private int nearestOfFew(int node, long[] pills, long powerPills) {
        int nearest = -1;
        int smallest = Integer.MAX_VALUE;
        for (int word = 0; word < pills.length; word++) {
            for (long bits = pills[word]; bits != 0; bits &= bits - 1) {
                int target = graph.pillNode(64 * word + Long.numberOfTrailingZeros(bits));
                int distance = distances.between(target, node);
                if (distance < smallest) {
                    smallest = distance;
                    nearest = target;
                }
            }
        }
        for (long bits = powerPills; bits != 0; bits &= bits - 1) {
            int target = graph.powerPillNode(Long.numberOfTrailingZeros(bits));
            int distance = distances.between(target, node);
            if (distance < smallest) {
                smallest = distance;
                nearest = target;
            }
        }
        return nearest;
    }
}
