package pacman.maze;

import java.util.Arrays;

/**
 * The competition's A* search for a path without turning back.
 *
 * <p>Its record of how a node was reached is kept per node, not per node and direction, so that the path found is not
 * always the shortest; and the order in which equal candidates leave the open list decides between equal paths. Both
 * are part of the simulator's behaviour, therefore the open list is the binary heap of {@link java.util.PriorityQueue},
 * step by step, over node numbers.
 *
 * <p>Source: docs/specification/simulator.md, section 4.3. One instance serves one thread.
 */
public final class NonReversingSearch {

    /** The search's estimate of the steps from a node to the target. */
    public interface Estimate {
        /** Returns the estimated number of steps between two nodes. */
        int steps(int from, int to);
    }

    private static final byte FRESH = 0;
    private static final byte OPEN = 1;
    private static final byte CLOSED = 2;

    /** Node reached from a node by a move, -1 if none, as {@link MazeGraph} keeps it. */
    private final short[] neighbours;

    private final byte[] status;
    /** Steps from the start. */
    private final int[] travelled;
    /** Steps from the start plus the estimate: what the heap orders by. */
    private final int[] total;

    private final int[] estimate;
    private final int[] parent;
    /** Direction of the step onto a node; 4 if there was none. */
    private final byte[] arrival;

    private int[] heap = new int[64];
    private int size;

    public NonReversingSearch(short[] neighbours) {
        this.neighbours = neighbours;
        int nodes = neighbours.length / MazeGraph.MOVES;
        status = new byte[nodes];
        travelled = new int[nodes];
        total = new int[nodes];
        estimate = new int[nodes];
        parent = new int[nodes];
        arrival = new byte[nodes];
    }

    /**
     * Returns the nodes of the path from a start to a target, both included.
     *
     * <p>The search can fail in a maze where a single corridor joins two parts. Then the result is the shortest path
     * that never turns back, found by breadth-first search. If no such path exists, the array holds the target alone.
     *
     * @param startArrival move by which the start was entered, 0 to 3: the path does not begin with its opposite; 4 if
     *     there was no move
     * @param distance estimate that guides the search
     */
    public int[] path(int start, int target, int startArrival, Estimate distance) {
        Arrays.fill(status, FRESH);
        Arrays.fill(parent, -1);
        size = 0;
        travelled[start] = 0;
        estimate[start] = distance.steps(start, target);
        total[start] = estimate[start];
        arrival[start] = (byte) startArrival;
        open(start);
        while (size > 0) {
            int node = poll();
            status[node] = CLOSED;
            if (node == target) {
                break;
            }
            expand(node, target, distance);
        }
        return target == start || parent[target] >= 0 ? pathTo(target) : exactPath(start, target, startArrival);
    }

    /** Breadth-first search over nodes and the moves by which they are entered. */
    private int[] exactPath(int start, int target, int startArrival) {
        int[] cameFrom = new int[neighbours.length];
        int[] queue = new int[neighbours.length];
        Arrays.fill(cameFrom, -1);
        int first = MazeGraph.MOVES * start + startArrival;
        cameFrom[first] = first;
        queue[0] = first;
        int count = 1;
        for (int head = 0; head < count; head++) {
            int node = queue[head] / MazeGraph.MOVES;
            int entered = queue[head] % MazeGraph.MOVES;
            if (node == target) {
                return trace(cameFrom, queue[head]);
            }
            for (int direction = 0; direction < 4; direction++) {
                int next = neighbours[MazeGraph.MOVES * node + direction];
                if (next < 0 || entered < 4 && direction == MazeGraph.opposite(entered)) {
                    continue;
                }
                int state = MazeGraph.MOVES * next + direction;
                if (cameFrom[state] < 0) {
                    cameFrom[state] = queue[head];
                    queue[count++] = state;
                }
            }
        }
        return new int[] {target};
    }

    private static int[] trace(int[] cameFrom, int last) {
        int length = 1;
        for (int state = last; cameFrom[state] != state; state = cameFrom[state]) {
            length++;
        }
        int[] path = new int[length];
        int state = last;
        for (int i = length - 1; i >= 0; i--) {
            path[i] = state / MazeGraph.MOVES;
            state = cameFrom[state];
        }
        return path;
    }

    private void expand(int node, int target, Estimate distance) {
        int cost = travelled[node] + 1;
        int back = arrival[node] < 4 ? MazeGraph.opposite(arrival[node]) : -1;
        for (int direction = 0; direction < 4; direction++) {
            int next = neighbours[MazeGraph.MOVES * node + direction];
            if (next < 0 || direction == back) {
                continue;
            }
            if (status[next] == FRESH) {
                estimate[next] = distance.steps(next, target);
                record(next, node, direction, cost);
                open(next);
            } else if (cost < travelled[next]) {
                // The heap is searched after the cost has changed, as in the original: its order may already be off.
                record(next, node, direction, cost);
                if (status[next] == OPEN) {
                    remove(next);
                }
                open(next);
            }
        }
    }

    private void record(int node, int from, int direction, int cost) {
        travelled[node] = cost;
        total[node] = cost + estimate[node];
        parent[node] = from;
        arrival[node] = (byte) direction;
    }

    private int[] pathTo(int target) {
        int length = 1;
        for (int node = target; parent[node] >= 0; node = parent[node]) {
            length++;
        }
        int[] path = new int[length];
        int node = target;
        for (int i = length - 1; i >= 0; i--) {
            path[i] = node;
            node = parent[node];
        }
        return path;
    }

    private void open(int node) {
        status[node] = OPEN;
        if (size == heap.length) {
            heap = Arrays.copyOf(heap, 2 * size);
        }
        size++;
        siftUp(size - 1, node);
    }

    private int poll() {
        int first = heap[0];
        size--;
        if (size > 0) {
            siftDown(0, heap[size]);
        }
        return first;
    }

    private void remove(int node) {
        int hole = 0;
        while (heap[hole] != node) {
            hole++;
        }
        size--;
        if (hole == size) {
            return;
        }
        int moved = heap[size];
        siftDown(hole, moved);
        if (heap[hole] == moved) {
            siftUp(hole, moved);
        }
    }

    private void siftUp(int from, int node) {
        int hole = from;
        while (hole > 0) {
            int above = (hole - 1) >>> 1;
            if (total[node] >= total[heap[above]]) {
                break;
            }
            heap[hole] = heap[above];
            hole = above;
        }
        heap[hole] = node;
    }

    private void siftDown(int from, int node) {
        int hole = from;
        int half = size >>> 1;
        while (hole < half) {
            int child = 2 * hole + 1;
            if (child + 1 < size && total[heap[child]] > total[heap[child + 1]]) {
                child++;
            }
            if (total[node] <= total[heap[child]]) {
                break;
            }
            heap[hole] = heap[child];
            hole = child;
        }
        heap[hole] = node;
    }
}
