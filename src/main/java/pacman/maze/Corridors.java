package pacman.maze;

import java.util.Arrays;

/**
 * The ways from each node along its corridor to the next junctions. Immutable.
 *
 * <p>A node between junctions has two legs, one per direction, in the order up, right, down, left of their first moves.
 * A junction has one leg of length 0 that ends in itself. The lair has none. A leg's path lists the nodes after the
 * start, the junction last.
 *
 * <p>Source: docs/specification/simulator.md, section 4.3 (legs).
 */
public final class Corridors {

    /** First and last move of a junction's own leg: none. */
    public static final int NO_MOVE = 4;

    private final MazeGraph graph;
    /** Nodes of each corridor from one end to the other, its junctions left out. */
    private final short[][] nodes;
    /** Corridor of a node; -1 for junctions and the lair. */
    private final short[] corridor;
    /** Place of a node in its corridor. */
    private final short[] position;

    /*
     * Legs, index 2 node + leg: the junction reached, the number of steps, the first and the last move, and whether the
     * leg leads towards higher positions in the corridor.
     */
    private final short[] junction;
    private final short[] length;
    private final byte[] firstMove;
    private final byte[] lastMove;
    private final boolean[] ascending;

    Corridors(MazeGraph graph) {
        this.graph = graph;
        int count = graph.nodeCount();
        corridor = new short[count];
        position = new short[count];
        junction = new short[2 * count];
        length = new short[2 * count];
        firstMove = new byte[2 * count];
        lastMove = new byte[2 * count];
        ascending = new boolean[2 * count];
        Arrays.fill(corridor, (short) -1);
        nodes = followAll();
        for (int node = 0; node < graph.lair(); node++) {
            if (graph.isJunction(node)) {
                junction[2 * node] = (short) node;
                firstMove[2 * node] = NO_MOVE;
                lastMove[2 * node] = NO_MOVE;
            } else {
                walkLegs(node);
            }
        }
    }

    private short[][] followAll() {
        short[][] found = new short[4 * graph.junctionCount()][];
        int count = 0;
        short[] buffer = new short[graph.nodeCount()];
        for (int number = 0; number < graph.junctionCount(); number++) {
            for (int direction = 0; direction < 4; direction++) {
                int first = graph.neighbour(graph.junctionNode(number), direction);
                if (first >= 0 && !graph.isJunction(first) && corridor[first] < 0) {
                    found[count] = follow(first, direction, count, buffer);
                    count++;
                }
            }
        }
        return Arrays.copyOf(found, count);
    }

    private short[] follow(int first, int arrival, int number, short[] buffer) {
        int size = 0;
        int node = first;
        int direction = arrival;
        while (!graph.isJunction(node)) {
            corridor[node] = (short) number;
            position[node] = (short) size;
            buffer[size++] = (short) node;
            direction = graph.onlyWayOn(node, direction);
            node = graph.neighbour(node, direction);
        }
        return Arrays.copyOf(buffer, size);
    }

    private void walkLegs(int start) {
        int leg = 2 * start;
        for (int direction = 0; direction < 4; direction++) {
            int node = graph.neighbour(start, direction);
            if (node < 0) {
                continue;
            }
            ascending[leg] = leadsUpwards(start, node, leg);
            firstMove[leg] = (byte) direction;
            int arrival = direction;
            int steps = 1;
            while (!graph.isJunction(node)) {
                arrival = graph.onlyWayOn(node, arrival);
                node = graph.neighbour(node, arrival);
                steps++;
            }
            junction[leg] = (short) node;
            lastMove[leg] = (byte) arrival;
            length[leg] = (short) steps;
            leg++;
        }
    }

    private boolean leadsUpwards(int start, int next, int leg) {
        if (corridor[next] >= 0) {
            return position[next] > position[start];
        }
        // The next node is a junction already. A corridor of one node has one leg each way.
        return nodes[corridor[start]].length == 1 ? (leg & 1) == 1 : position[start] > 0;
    }

    /** Number of corridors. */
    int count() {
        return nodes.length;
    }

    /** Number of nodes of a corridor, its junctions left out. */
    int size(int number) {
        return nodes[number].length;
    }

    /** The node at a position of a corridor, from 0. */
    int node(int number, int at) {
        return nodes[number][at];
    }

    /** Number of a node's corridor; -1 for junctions and the lair. */
    int corridor(int node) {
        return corridor[node];
    }

    /** Position of a node in its corridor. */
    int position(int node) {
        return position[node];
    }

    /** The leg of a node between junctions that leaves it in an open direction. */
    int legTowards(int node, int direction) {
        return firstMove(node, 0) == direction ? 0 : 1;
    }

    /** Whether a leg leads towards higher positions in its corridor. */
    boolean isAscending(int node, int leg) {
        return ascending[2 * node + leg];
    }

    /** Number of legs: 0 in the lair, 1 at a junction, 2 elsewhere. */
    public int legCount(int node) {
        int degree = graph.degree(node);
        return degree == 0 ? 0 : degree == 2 ? 2 : 1;
    }

    /** Node of the junction that a leg reaches. */
    public int junction(int node, int leg) {
        return junction[2 * node + leg];
    }

    /** Steps to the junction. */
    public int length(int node, int leg) {
        return length[2 * node + leg];
    }

    /** First direction of a leg, {@link #NO_MOVE} for a junction's own. */
    public int firstMove(int node, int leg) {
        return firstMove[2 * node + leg];
    }

    /** Direction in which a leg enters its junction, {@link #NO_MOVE} for a junction's own. */
    public int lastMove(int node, int leg) {
        return lastMove[2 * node + leg];
    }

    /** Steps from a node along one of its legs to a target on it; -1 if the target is not on the leg's path. */
    public int lengthTo(int node, int leg, int target) {
        int own = corridor[node];
        if (own < 0) {
            return -1;
        }
        if (corridor[target] == own) {
            int ahead = position[target] - position[node];
            if (!ascending[2 * node + leg]) {
                ahead = -ahead;
            }
            return ahead > 0 ? ahead : -1;
        }
        return target == junction(node, leg) ? length(node, leg) : -1;
    }

    /**
     * Writes the first {@code count} nodes of a leg's path to {@code out} from {@code from}; returns the place after
     * them.
     */
    int write(int node, int leg, int count, int[] out, int from) {
        int next = from;
        short[] own = count > 0 ? nodes[corridor[node]] : null;
        int step = ascending[2 * node + leg] ? 1 : -1;
        for (int i = 1; i <= count; i++) {
            out[next++] = i == length(node, leg) ? junction(node, leg) : own[position[node] + step * i];
        }
        return next;
    }

    /** Writes the way from a leg's junction, itself left out, to the node; returns the place after it. */
    int writeBack(int node, int leg, int[] out, int from) {
        int next = from;
        int step = ascending[2 * node + leg] ? 1 : -1;
        for (int i = length(node, leg) - 1; i >= 0; i--) {
            out[next++] = nodes[corridor[node]][position[node] + step * i];
        }
        return next;
    }
}
