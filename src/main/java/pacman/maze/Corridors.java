package pacman.maze;

import java.util.Arrays;

/**
 * The ways from each node along its corridor to the next junctions. Immutable.
 *
 * <p>A node between junctions has two legs, one per direction, in the order up, right, down, left of their first moves.
 * A junction has one leg of length 0 that ends in itself. The lair has none.
 *
 * <p>Source: docs/specification/simulator.md, section 4.3 (legs).
 */
final class Corridors {

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
     * Legs, index 2 node + leg, a junction's own twice. Each holds, from its lowest bit on: the number of steps, the
     * first and the last move, whether the leg leads towards higher positions in the corridor, and the number of the
     * junction reached.
     */
    private static final int STEPS_MASK = 0xFFF;
    private static final int FIRST_SHIFT = 12;
    private static final int LAST_SHIFT = 15;
    private static final int MOVE_MASK = 7;
    private static final int ASCENDING = 1 << 18;
    private static final int JUNCTION_SHIFT = 20;

    private final int[] legs;

    Corridors(MazeGraph graph) {
        this.graph = graph;
        int count = graph.nodeCount();
        corridor = new short[count];
        position = new short[count];
        legs = new int[2 * count];
        Arrays.fill(corridor, (short) -1);
        nodes = followAll();
        for (int node = 0; node < graph.lair(); node++) {
            if (graph.isJunction(node)) {
                int own = pack(0, NO_MOVE, NO_MOVE, false, graph.junctionNumber(node));
                Arrays.fill(legs, 2 * node, 2 * node + 2, own);
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
            boolean ascending = leadsUpwards(start, node, leg);
            int arrival = direction;
            int steps = 1;
            while (!graph.isJunction(node)) {
                arrival = graph.onlyWayOn(node, arrival);
                node = graph.neighbour(node, arrival);
                steps++;
            }
            legs[leg++] = pack(steps, direction, arrival, ascending, graph.junctionNumber(node));
        }
    }

    private static int pack(int steps, int firstMove, int lastMove, boolean ascending, int junction) {
        return steps
                | firstMove << FIRST_SHIFT
                | lastMove << LAST_SHIFT
                | (ascending ? ASCENDING : 0)
                | junction << JUNCTION_SHIFT;
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
        return (legs[2 * node + leg] & ASCENDING) != 0;
    }

    /** Number of legs: 0 in the lair, 1 at a junction, 2 elsewhere. */
    public int legCount(int node) {
        int degree = graph.degree(node);
        return degree == 0 ? 0 : degree == 2 ? 2 : 1;
    }

    /** Node of the junction that a leg reaches. */
    public int junction(int node, int leg) {
        return graph.junctionNode(junctionNumber(legs[2 * node + leg]));
    }

    /** Steps to the junction. */
    public int length(int node, int leg) {
        return steps(legs[2 * node + leg]);
    }

    /** First direction of a leg, {@link #NO_MOVE} for a junction's own. */
    public int firstMove(int node, int leg) {
        return legs[2 * node + leg] >> FIRST_SHIFT & MOVE_MASK;
    }

    /** Direction in which a leg enters its junction, {@link #NO_MOVE} for a junction's own. */
    public int lastMove(int node, int leg) {
        return legs[2 * node + leg] >> LAST_SHIFT & MOVE_MASK;
    }

    /** A leg as one number, for {@link #steps} and {@link #junctionNumber}; a junction's own has two equal ones. */
    int leg(int node, int leg) {
        return legs[2 * node + leg];
    }

    /** Steps of a leg to its junction. */
    static int steps(int leg) {
        return leg & STEPS_MASK;
    }

    /** Number of the junction that a leg reaches. */
    static int junctionNumber(int leg) {
        return leg >> JUNCTION_SHIFT;
    }

    /** Writes the way from a leg's junction, itself left out, to the node; returns the place after it. */
    int writeBack(int node, int leg, int[] out, int from) {
        int next = from;
        int step = isAscending(node, leg) ? 1 : -1;
        for (int i = length(node, leg) - 1; i >= 0; i--) {
            out[next++] = nodes[corridor[node]][position[node] + step * i];
        }
        return next;
    }
}
