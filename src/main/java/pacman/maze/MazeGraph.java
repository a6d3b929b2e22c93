package pacman.maze;

import java.util.Arrays;

/**
 * The graph of a maze: one node per pixel of the corridors' centre lines, one step long each, and the lair as the last
 * node, which no path reaches. Immutable.
 *
 * <p>Nodes are numbered by y, then x. Directions are 0 up, 1 right, 2 down, 3 left. A
 * corridor pixel on the left border leads to the one on the right border in the same row: a tunnel.
 *
 * <p>Source: docs/specification/simulator.md, sections 1.2 and 7 (removePillsNearPowerPills).
 */
public final class MazeGraph {

    /** Columns of the neighbour table: four directions and no move, so that looking up a move needs no test. */
    public static final int MOVES = 5;

    /** No node, no corridor, no junction. */
    public static final int NONE = -1;

    private static final int UP_OR_DOWN = 0b0101;
    private static final int[] STEP_X = {0, 1, 0, -1};
    private static final int[] STEP_Y = {-1, 0, 1, 0};

    private final String name;
    private final int nodeCount;
    /**
     * Node reached from a node by a move, -1 if none; index {@value #MOVES} node + move. Move 4, none, leads nowhere.
     */
    private final short[] neighbours;
    /** Bit set of the open directions of a node. */
    private final byte[] openDirections;
    /** Number of neighbours per node: 0 in the lair, else 2 to 4. */
    private final byte[] degree;

    private final short[] x;
    private final short[] y;
    /** Number of the pill on a node, -1 if none. */
    private final short[] pillNumber;
    /** Number of the pill on a node, or of a bit that stands for no pill. */
    private final short[] pillPosition;
    /** Number of the power pill on a node, -1 if none. */
    private final short[] powerPillNumber;
    /** Number of the junction at a node, -1 if it is none. */
    private final short[] junctionNumber;

    private final int[] pillNodes;
    private final int[] powerPillNodes;
    private final int[] junctionNodes;
    private final int pacManStart;
    private final int ghostStart;
    /** Bit set of pill numbers on the corridors of power pills. */
    private final long[] pillsNearPowerPills;

    /**
     * Builds the graph of a drawing.
     *
     * @throws MazeFormatException if the maze cannot be played: a dead end, a corridor that cannot be reached, no pills
     */
    MazeGraph(String name, MazeDrawing drawing) {
        this.name = name;
        int[][] nodeAt = numberPixels(drawing);
        int count = 0;
        for (int[] row : nodeAt) {
            for (int node : row) {
                count = Math.max(count, node + 1);
            }
        }
        nodeCount = count + 1;
        x = new short[nodeCount];
        y = new short[nodeCount];
        neighbours = new short[MOVES * nodeCount];
        openDirections = new byte[nodeCount];
        degree = new byte[nodeCount];
        Arrays.fill(neighbours, (short) -1);
        link(nodeAt);
        x[count] = (short) drawing.lair()[0];
        y[count] = (short) drawing.lair()[1];
        pacManStart = nodeAt[drawing.pacManStart()[1]][drawing.pacManStart()[0]];
        ghostStart = nodeAt[drawing.ghostStart()[1]][drawing.ghostStart()[0]];

        pillNumber = new short[nodeCount];
        powerPillNumber = new short[nodeCount];
        junctionNumber = new short[nodeCount];
        pillNodes = numbered(pillNumber, node -> drawing.isPill(x[node], y[node]));
        powerPillNodes = numbered(powerPillNumber, node -> drawing.isPowerPill(x[node], y[node]));
        junctionNodes = numbered(junctionNumber, node -> degree[node] > 2);
        check(drawing);
        pillPosition = findPillPositions();
        pillsNearPowerPills = findPillsNearPowerPills();
    }

    private static int[][] numberPixels(MazeDrawing drawing) {
        int[][] nodeAt = new int[MazeDrawing.HEIGHT][MazeDrawing.WIDTH];
        int next = 0;
        for (int row = 0; row < MazeDrawing.HEIGHT; row++) {
            for (int column = 0; column < MazeDrawing.WIDTH; column++) {
                nodeAt[row][column] = drawing.isCorridor(column, row) ? next++ : -1;
            }
        }
        return nodeAt;
    }

    private void link(int[][] nodeAt) {
        for (int row = 0; row < MazeDrawing.HEIGHT; row++) {
            for (int column = 0; column < MazeDrawing.WIDTH; column++) {
                int node = nodeAt[row][column];
                if (node < 0) {
                    continue;
                }
                x[node] = (short) column;
                y[node] = (short) row;
                for (int direction = 0; direction < 4; direction++) {
                    int toRow = row + STEP_Y[direction];
                    int toColumn = Math.floorMod(column + STEP_X[direction], MazeDrawing.WIDTH);
                    int to = toRow < 0 || toRow >= MazeDrawing.HEIGHT ? -1 : nodeAt[toRow][toColumn];
                    neighbours[MOVES * node + direction] = (short) to;
                    if (to >= 0) {
                        degree[node]++;
                        openDirections[node] |= (byte) (1 << direction);
                    }
                }
            }
        }
    }

    /** Numbers the nodes that satisfy a condition, in node order; others get -1. Returns the nodes by number. */
    private int[] numbered(short[] numbers, java.util.function.IntPredicate condition) {
        int[] nodes = new int[nodeCount];
        int count = 0;
        for (int node = 0; node < nodeCount; node++) {
            boolean counts = node != lair() && condition.test(node);
            numbers[node] = (short) (counts ? count : -1);
            if (counts) {
                nodes[count++] = node;
            }
        }
        return Arrays.copyOf(nodes, count);
    }

    private short[] findPillPositions() {
        short[] positions = pillNumber.clone();
        for (int node = 0; node < nodeCount; node++) {
            if (positions[node] < 0) {
                positions[node] = (short) (Long.SIZE * pillWords() - 1);
            }
        }
        return positions;
    }

    private void check(MazeDrawing drawing) {
        for (int node = 0; node < lair(); node++) {
            boolean atBorder = x[node] == 0 || x[node] == MazeDrawing.WIDTH - 1;
            if (atBorder && (openDirections[node] & UP_OR_DOWN) != 0) {
                throw drawing.errorAtPixel(
                        x[node], y[node], "corridor along the border: only tunnels, which run sideways, reach it");
            }
            if (degree[node] < 2) {
                throw drawing.errorAtPixel(
                        x[node],
                        y[node],
                        atBorder
                                ? "dead end: this tunnel has no opening on the other side"
                                : "dead end: both ends of a corridor must lead to other corridors");
            }
        }
        boolean[] reached = reachableFrom(pacManStart);
        for (int node = 0; node < lair(); node++) {
            if (!reached[node]) {
                throw drawing.errorAtPixel(
                        x[node], y[node], "unreachable corridor: there is no path from Ms. Pac-Man's start to here");
            }
        }
        if (nodeCount > MazePoses.MAXIMUM_NODES) {
            int node = MazePoses.MAXIMUM_NODES - 1;
            throw drawing.errorAtPixel(
                    x[node],
                    y[node],
                    "corridors too long: at most " + (MazePoses.MAXIMUM_NODES - 1)
                            + " steps in all, four from tile to tile");
        }
        if (pillNodes.length == 0) {
            throw drawing.errorAtPixel(x[pacManStart], y[pacManStart], "no pills: the maze needs at least one '.'");
        }
        if (powerPillNodes.length > Long.SIZE) {
            int node = powerPillNodes[Long.SIZE];
            throw drawing.errorAtPixel(x[node], y[node], "more than " + Long.SIZE + " power pills");
        }
        if (junctionNodes.length == 0) {
            throw drawing.errorAtPixel(
                    x[pacManStart],
                    y[pacManStart],
                    "no junction: the maze needs a place where at least three corridors meet");
        }
    }

    private boolean[] reachableFrom(int start) {
        boolean[] reached = new boolean[nodeCount];
        int[] queue = new int[nodeCount];
        int size = 0;
        queue[size++] = start;
        reached[start] = true;
        for (int head = 0; head < size; head++) {
            for (int direction = 0; direction < 4; direction++) {
                int next = neighbours[MOVES * queue[head] + direction];
                if (next >= 0 && !reached[next]) {
                    reached[next] = true;
                    queue[size++] = next;
                }
            }
        }
        return reached;
    }

    /** Walks both ways from each power pill up to, but not onto, the first junction. */
    private long[] findPillsNearPowerPills() {
        long[] near = new long[pillWords()];
        for (int powerPill : powerPillNodes) {
            int ways = 0;
            for (int direction = 0; direction < 4 && ways < 2; direction++) {
                if (neighbour(powerPill, direction) >= 0) {
                    ways++;
                    markPillsAlong(powerPill, direction, near);
                }
            }
        }
        return near;
    }

    private void markPillsAlong(int powerPill, int firstMove, long[] near) {
        int direction = firstMove;
        int node = neighbour(powerPill, direction);
        while (degree[node] == 2 && node != powerPill) {
            int pill = pillNumber[node];
            if (pill >= 0) {
                near[pill >> 6] |= 1L << pill;
            }
            direction = onlyWayOn(node, direction);
            node = neighbour(node, direction);
        }
    }

    /** The direction that leads back; not for 4, no move. */
    public static int opposite(int direction) {
        return direction ^ 2;
    }

    /** The first direction, in order, that is not the way back. */
    int onlyWayOn(int node, int arrival) {
        int back = opposite(arrival);
        for (int direction = 0; direction < 4; direction++) {
            if (direction != back && neighbours[MOVES * node + direction] >= 0) {
                return direction;
            }
        }
        throw new IllegalStateException("node " + node + " of maze " + name + " is a dead end");
    }

    /** Letter or file name of the maze. */
    public String name() {
        return name;
    }

    /** Number of nodes, the lair included. */
    public int nodeCount() {
        return nodeCount;
    }

    /** The node of the lair, the last one. */
    public int lair() {
        return nodeCount - 1;
    }

    /** Node on which Ms. Pac-Man starts a level. */
    public int pacManStart() {
        return pacManStart;
    }

    /** Node on which ghosts appear when they leave the lair. */
    public int ghostStart() {
        return ghostStart;
    }

    /** The node next to {@code node} in a direction 0 to 3, -1 if there is none; -1 for 4, no move. */
    public int neighbour(int node, int move) {
        return neighbours[MOVES * node + move];
    }

    /** Whether a node has a neighbour in a direction 0 to 3. */
    public boolean isOpen(int node, int direction) {
        return neighbour(node, direction) >= 0;
    }

    /** Bit set of the directions in which a node has a neighbour. */
    public int openDirections(int node) {
        return openDirections[node];
    }

    /** Number of neighbours: 0 in the lair, else 2 to 4. */
    public int degree(int node) {
        return degree[node];
    }

    /** Horizontal position in pixels, 0 to 108. */
    public int x(int node) {
        return x[node];
    }

    /** Vertical position in pixels, growing downwards, 4 to 116. */
    public int y(int node) {
        return y[node];
    }

    /**
     * A lower bound of the path distance, from the positions alone. Every step changes one coordinate by one; a tunnel
     * joins the first and the last column, so that horizontal differences count around the border too.
     */
    public int leastDistance(int from, int to) {
        int dx = Math.abs(x[from] - x[to]);
        return Math.min(dx, MazeDrawing.WIDTH - dx) + Math.abs(y[from] - y[to]);
    }

    /** Number of the pill on a node, -1 if there never was one. */
    public int pillNumber(int node) {
        return pillNumber[node];
    }

    /** Number of the power pill on a node, -1 if there never was one. */
    public int powerPillNumber(int node) {
        return powerPillNumber[node];
    }

    /** Number of the junction at a node, -1 if it has fewer than three neighbours. */
    public int junctionNumber(int node) {
        return junctionNumber[node];
    }

    public boolean isJunction(int node) {
        return degree[node] > 2;
    }

    public int pillCount() {
        return pillNodes.length;
    }

    public int powerPillCount() {
        return powerPillNodes.length;
    }

    public int junctionCount() {
        return junctionNodes.length;
    }

    /** Node of a pill by its number. */
    public int pillNode(int pill) {
        return pillNodes[pill];
    }

    /** Node of a power pill by its number. */
    public int powerPillNode(int powerPill) {
        return powerPillNodes[powerPill];
    }

    /** Node of a junction by its number. */
    public int junctionNode(int junction) {
        return junctionNodes[junction];
    }

    /**
     * Index of a node's bit in a bit set of pills: bit {@code index & 63} of word {@code index >> 6}. It is the number
     * of the node's pill. All nodes without a pill share the last bit of the set, which is never set. So a caller can
     * test the bit of any node without asking for a pill first.
     */
    public int pillPosition(int node) {
        return pillPosition[node];
    }

    /** Number of longs in a bit set of pills. The last bit belongs to the nodes without a pill and is never set. */
    public int pillWords() {
        return (pillNodes.length >> 6) + 1;
    }

    /** A word (64 pills) of the bit set of the pills that lie on the corridor of a power pill. */
    public long pillsNearPowerPills(int word) {
        return pillsNearPowerPills[word];
    }

    /** The table of neighbours, index {@value #MOVES} node + move; not to be modified. */
    short[] neighbours() {
        return neighbours;
    }

    /** A copy of the nodes of all pills, by number. */
    public int[] pillNodes() {
        return pillNodes.clone();
    }

    /** A copy of the nodes of all power pills, by number. */
    public int[] powerPillNodes() {
        return powerPillNodes.clone();
    }

    /** A copy of the nodes of all junctions, by number. */
    public int[] junctionNodes() {
        return junctionNodes.clone();
    }
}
