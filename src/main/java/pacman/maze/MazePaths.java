package pacman.maze;

import java.util.Arrays;

/**
 * The paths that the simulator gives, which are not always the shortest: corridor, path between two junctions,
 * corridor. Immutable.
 *
 * <p>A path lists the nodes after the start, the target last; its length is its number of steps; it is empty if start
 * and target are the same. Directions are 0 up, 1 right, 2 down, 3 left; a last move may also be 4, none.
 *
 * <p>Source: docs/specification/simulator.md, sections 4.3 and 4.4.
 */
public final class MazePaths {

    private static final int NO_MOVE = Corridors.NO_MOVE;
    private static final int[] EMPTY = {};

    /*
     * A directed path from a corridor node is its leg to a junction J, entered by a move, and then what leads on from
     * there. So only the rows of (J, entering move) are stored, J times 5 times nodes shorts, about half a megabyte per
     * maze, and a length is one or two look-ups and a sum.
     */
    private final MazeGraph graph;
    private final MazeDistances distances;
    private final Corridors corridors;
    private final int junctions;
    /**
     * Where the path from junction J by move m to junction K starts in {@link #pathNodes}; index (4 J + m) junctions +
     * K.
     */
    private final int[] pathStart;

    private final short[] pathNodes;
    /** First move of the shortest path from junction J to junction K; index J junctions + K. */
    private final byte[] bestMove;
    /** Steps on from a junction, entered by a move, to any node; index (5 junction + move) nodes + target. */
    private final short[] onwards;

    MazePaths(MazeGraph graph, MazeDistances distances, Corridors corridors) {
        this.graph = graph;
        this.distances = distances;
        this.corridors = corridors;
        junctions = graph.junctionCount();
        pathStart = new int[4 * junctions * junctions + 1];
        pathNodes = searchJunctionPaths();
        bestMove = findBestMoves();
        onwards = new short[5 * junctions * graph.nodeCount()];
        for (int junction = 0; junction < junctions; junction++) {
            for (int arrival = 0; arrival <= NO_MOVE; arrival++) {
                fillOnwards(junction, arrival);
            }
        }
    }

    private short[] searchJunctionPaths() {
        NonReversingSearch search = new NonReversingSearch(graph.neighbours());
        short[] found = new short[1 << 16];
        int size = 0;
        int index = 0;
        for (int from = 0; from < junctions; from++) {
            for (int move = 0; move < 4; move++) {
                int first = graph.neighbour(graph.junctionNode(from), move);
                for (int to = 0; to < junctions; to++) {
                    if (first >= 0) {
                        int[] path = search.path(first, graph.junctionNode(to), move, distances::between);
                        if (size + path.length > found.length) {
                            found = Arrays.copyOf(found, 2 * found.length + path.length);
                        }
                        for (int node : path) {
                            found[size++] = (short) node;
                        }
                    }
                    pathStart[++index] = size;
                }
            }
        }
        return Arrays.copyOf(found, size);
    }

    private byte[] findBestMoves() {
        byte[] best = new byte[junctions * junctions];
        for (int from = 0; from < junctions; from++) {
            for (int to = 0; to < junctions; to++) {
                int shortest = Integer.MAX_VALUE;
                for (int move = 0; move < 4; move++) {
                    int length = junctionPathLength(from, move, to);
                    if (length > 0 && length < shortest) {
                        shortest = length;
                        best[from * junctions + to] = (byte) move;
                    }
                }
            }
        }
        return best;
    }

    private void fillOnwards(int junction, int arrival) {
        int row = (5 * junction + arrival) * graph.nodeCount();
        for (int target = 0; target < graph.lair(); target++) {
            if (target != graph.junctionNode(junction)) {
                onwards[row + target] = (short) routeLength(choose(junction, arrival, target), junction, target);
            }
        }
    }

    /**
     * How the directed path goes on from a junction entered by a move: the target's leg plus 2 times (1 + the move at
     * the junction), or plus 0 if the target's corridor starts right there.
     */
    private int choose(int junction, int arrival, int target) {
        int chosen = -1;
        int shortest = Integer.MAX_VALUE;
        for (int leg = 0; leg < corridors.legCount(target); leg++) {
            int end = graph.junctionNumber(corridors.junction(target, leg));
            int length = corridors.length(target, leg);
            if (end == junction) {
                // Replaces an earlier candidate even if that was shorter.
                if (corridors.lastMove(target, leg) != arrival) {
                    chosen = leg;
                    shortest = length;
                }
                continue;
            }
            for (int move = 0; move < 4; move++) {
                int way = junctionPathLength(junction, move, end);
                if (way > 0 && !isBack(move, arrival) && way + length < shortest) {
                    chosen = leg + 2 * (1 + move);
                    shortest = way + length;
                }
            }
        }
        if (chosen < 0) {
            throw new IllegalStateException("no way on from junction " + graph.junctionNode(junction) + " to node "
                    + target + " of maze " + graph.name());
        }
        return chosen;
    }

    private int routeLength(int choice, int junction, int target) {
        int leg = choice & 1;
        int move = (choice >> 1) - 1;
        int end = graph.junctionNumber(corridors.junction(target, leg));
        return (move < 0 ? 0 : junctionPathLength(junction, move, end)) + corridors.length(target, leg);
    }

    private static boolean isBack(int move, int arrival) {
        return arrival < NO_MOVE && MazeGraph.opposite(arrival) == move;
    }

    public MazeGraph graph() {
        return graph;
    }

    public Corridors corridors() {
        return corridors;
    }

    /**
     * Steps of the stored path from one junction to another that starts with a move; 0 if the move is not open.
     *
     * @param from number of the junction left
     * @param to number of the junction reached, which may be the same
     */
    public int junctionPathLength(int from, int move, int to) {
        int index = (4 * from + move) * junctions + to;
        return pathStart[index + 1] - pathStart[index];
    }

    /** A node of the stored path between two junctions: step 0 is the neighbour by the move. */
    public int junctionPathNode(int from, int move, int to, int step) {
        return pathNodes[pathStart[(4 * from + move) * junctions + to] + step];
    }

    /** First move of the shortest stored path from one junction to a different one. */
    public int bestMove(int from, int to) {
        return bestMove[from * junctions + to];
    }

    /**
     * Length of the path that must not turn back, from a node that was entered by a last move.
     *
     * @param lastMove 0 to 3, or 4 for none
     * @throws IndexOutOfBoundsException if only the target is the lair
     */
    public int directedLength(int from, int to, int lastMove) {
        if (from == to || from == graph.lair()) {
            return 0;
        }
        requireReachable(to);
        if (graph.isJunction(from)) {
            return onwardsLength(graph.junctionNumber(from), lastMove, to);
        }
        int leg = directedLeg(from, lastMove);
        int along = corridors.lengthTo(from, leg, to);
        if (along >= 0) {
            return along;
        }
        int junction = graph.junctionNumber(corridors.junction(from, leg));
        return corridors.length(from, leg) + onwardsLength(junction, corridors.lastMove(from, leg), to);
    }

    /**
     * Steps of the directed path from a junction, entered by a move (4: none), to any other node.
     *
     * @param junction number of the junction
     */
    public int onwardsLength(int junction, int arrival, int to) {
        return onwards[(5 * junction + arrival) * graph.nodeCount() + to];
    }

    /**
     * The leg by which a directed path leaves a node between junctions: not back; of both, the shorter, first on ties.
     */
    public int directedLeg(int from, int lastMove) {
        boolean first = !isBack(corridors.firstMove(from, 0), lastMove);
        boolean second = !isBack(corridors.firstMove(from, 1), lastMove);
        if (first && second) {
            return corridors.length(from, 1) < corridors.length(from, 0) ? 1 : 0;
        }
        return first ? 0 : 1;
    }

    /** The path whose length {@link #directedLength} gives. */
    public int[] directedPath(int from, int to, int lastMove) {
        if (from == to || from == graph.lair()) {
            return EMPTY;
        }
        int[] path = new int[directedLength(from, to, lastMove)];
        writeDirected(from, to, lastMove, path, 0);
        return path;
    }

    /**
     * Writes that path to {@code path} from {@code start} on.
     *
     * @return the place after it
     */
    int writeDirected(int from, int to, int lastMove, int[] path, int start) {
        if (from == to || from == graph.lair()) {
            return start;
        }
        int junction = graph.junctionNumber(from);
        int arrival = lastMove;
        int next = start;
        if (junction < 0) {
            int leg = directedLeg(from, lastMove);
            int along = corridors.lengthTo(from, leg, to);
            if (along >= 0) {
                return corridors.write(from, leg, along, path, start);
            }
            next = corridors.write(from, leg, corridors.length(from, leg), path, start);
            junction = graph.junctionNumber(corridors.junction(from, leg));
            arrival = corridors.lastMove(from, leg);
        }
        int choice = choose(junction, arrival, to);
        int leg = choice & 1;
        int move = (choice >> 1) - 1;
        if (move >= 0) {
            next = writeJunctionPath(junction, move, graph.junctionNumber(corridors.junction(to, leg)), path, next);
        }
        return corridors.writeBack(to, leg, path, next);
    }

    /**
     * Length of the path on which the start may be left in any direction.
     *
     * @throws IndexOutOfBoundsException if one node is the lair
     */
    public int undirectedLength(int from, int to) {
        if (from == to) {
            return 0;
        }
        requireReachable(from);
        requireReachable(to);
        for (int leg = 0; leg < corridors.legCount(from); leg++) {
            int along = corridors.lengthTo(from, leg, to);
            if (along >= 0) {
                return along;
            }
        }
        return undirectedLength(from, to, chooseLegs(from, to));
    }

    /** The path whose length {@link #undirectedLength} gives. */
    public int[] undirectedPath(int from, int to) {
        if (from == to) {
            return EMPTY;
        }
        int[] path = new int[undirectedLength(from, to)];
        for (int leg = 0; leg < corridors.legCount(from); leg++) {
            int along = corridors.lengthTo(from, leg, to);
            if (along >= 0) {
                corridors.write(from, leg, along, path, 0);
                return path;
            }
        }
        int legs = chooseLegs(from, to);
        int out = legs & 1;
        int in = legs >> 1;
        int next = corridors.write(from, out, corridors.length(from, out), path, 0);
        int first = graph.junctionNumber(corridors.junction(from, out));
        int last = graph.junctionNumber(corridors.junction(to, in));
        if (first != last) {
            next = writeJunctionPath(first, bestMove(first, last), last, path, next);
        }
        corridors.writeBack(to, in, path, next);
        return path;
    }

    /** The start's leg plus 2 times the target's leg of the first shortest combination. */
    private int chooseLegs(int from, int to) {
        int chosen = 0;
        int shortest = Integer.MAX_VALUE;
        for (int out = 0; out < corridors.legCount(from); out++) {
            for (int in = 0; in < corridors.legCount(to); in++) {
                int length = undirectedLength(from, to, out + 2 * in);
                if (length < shortest) {
                    shortest = length;
                    chosen = out + 2 * in;
                }
            }
        }
        return chosen;
    }

    private int undirectedLength(int from, int to, int legs) {
        int out = legs & 1;
        int in = legs >> 1;
        int first = graph.junctionNumber(corridors.junction(from, out));
        int last = graph.junctionNumber(corridors.junction(to, in));
        int between = first == last ? 0 : junctionPathLength(first, bestMove(first, last), last);
        return corridors.length(from, out) + between + corridors.length(to, in);
    }

    private int writeJunctionPath(int from, int move, int to, int[] out, int start) {
        int next = start;
        int index = (4 * from + move) * junctions + to;
        for (int i = pathStart[index]; i < pathStart[index + 1]; i++) {
            out[next++] = pathNodes[i];
        }
        return next;
    }

    private void requireReachable(int node) {
        if (node == graph.lair()) {
            throw new IndexOutOfBoundsException("no path leads into the lair (node " + node + ")");
        }
    }
}
