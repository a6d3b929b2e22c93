package pacman.maze;

import java.util.Arrays;

/**
 * The corridors of a maze: chains of nodes with two neighbours, from junction to junction.
 *
 * <p>The nodes of a corridor are numbered by position from 0; position -1 and the position behind the last one stand for the
 * junctions at its ends. Directions are numbered UP 0, RIGHT 1, DOWN 2, LEFT 3.
 */
public final class CorridorPositions {

    /** No node, no corridor. */
    public static final int NONE = -1;

    private final MazeGraph graph;

    /** Nodes of each corridor, by position. */
    private final int[][] nodes;

    /** Corridor of each node; {@link #NONE} for junctions and the lair. */
    private final int[] corridorOf;

    private final int[] positionOf;

    public CorridorPositions(MazeGraph graph) {
        this.graph = graph;
        corridorOf = new int[graph.nodeCount()];
        positionOf = new int[graph.nodeCount()];
        Arrays.fill(corridorOf, NONE);
        nodes = find();
    }

    private int[][] find() {
        int[][] found = new int[graph.nodeCount()][];
        int count = 0;
        int[] walk = new int[graph.nodeCount()];
        for (int j = 0; j < graph.junctionCount(); j++) {
            for (int d = 0; d < 4; d++) {
                int length = 0;
                int move = d;
                int node = graph.neighbour(graph.junctionNode(j), d);
                while (node != NONE && !graph.isJunction(node) && corridorOf[node] == NONE) {
                    walk[length] = node;
                    corridorOf[node] = count;
                    positionOf[node] = length++;
                    move = onward(graph, node, move);
                    node = graph.neighbour(node, move);
                }
                if (length > 0) {
                    found[count++] = Arrays.copyOf(walk, length);
                }
            }
        }
        return Arrays.copyOf(found, count);
    }

    /** Corridor of a node, {@link #NONE} for junctions and the lair. */
    public int corridorOf(int node) {
        return corridorOf[node];
    }

    /** Position of a node in its corridor. */
    public int positionOf(int node) {
        return positionOf[node];
    }

    /** Number of corridors. */
    public int count() {
        return nodes.length;
    }

    /** Number of nodes of a corridor. */
    public int length(int corridor) {
        return nodes[corridor].length;
    }

    /** The node at a position of a corridor. */
    public int node(int corridor, int position) {
        return nodes[corridor][position];
    }

    /** The direction in which a corridor goes on at a node that was entered by a move. */
    public static int onward(MazeGraph graph, int node, int move) {
        int d = 0;
        while (d == opposite(move) || graph.neighbour(node, d) == NONE) {
            d++;
        }
        return d;
    }

    public static int opposite(int direction) {
        return direction ^ 2;
    }
}
