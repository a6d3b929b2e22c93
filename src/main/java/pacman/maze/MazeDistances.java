package pacman.maze;

/**
 * Path distances between all nodes of a maze, where turning back is allowed. Immutable.
 *
 * <p>Source: docs/specification/simulator.md, sections 1.1 and 4.1.
 */
public final class MazeDistances {

    /*
     * A full table instead of its triangular half: a question about several nodes and one target reads one row, and
     * neighbouring nodes lie beside each other in it. Two bytes per entry, 3.4 MB for a maze of 1300 nodes.
     */
    private final short[] distance;

    private final int nodeCount;

    MazeDistances(MazeGraph graph) {
        nodeCount = graph.nodeCount();
        distance = new short[nodeCount * nodeCount];
        int[] queue = new int[nodeCount];
        for (int start = 0; start < nodeCount; start++) {
            fillRow(graph, start, queue);
        }
    }

    /** Breadth-first search. */
    private void fillRow(MazeGraph graph, int start, int[] queue) {
        int row = start * nodeCount;
        java.util.Arrays.fill(distance, row, row + nodeCount, (short) -1);
        distance[row + start] = 0;
        queue[0] = start;
        int size = 1;
        for (int head = 0; head < size; head++) {
            int node = queue[head];
            short next = (short) (distance[row + node] + 1);
            for (int direction = 0; direction < 4; direction++) {
                int neighbour = graph.neighbour(node, direction);
                if (neighbour >= 0 && distance[row + neighbour] < 0) {
                    distance[row + neighbour] = next;
                    queue[size++] = neighbour;
                }
            }
        }
    }

    /** Steps between two nodes: 0 if they are the same, -1 if one is the lair. */
    public int between(int from, int to) {
        return distance[to * nodeCount + from];
    }

    /** The table that the competition's {@code Maze} publishes: entry t (t + 1) / 2 + s for {@code s <= t}. */
    public int[] triangular() {
        int[] half = new int[nodeCount * (nodeCount + 1) / 2];
        int next = 0;
        for (int to = 0; to < nodeCount; to++) {
            for (int from = 0; from <= to; from++) {
                half[next++] = between(from, to);
            }
        }
        return half;
    }
}
