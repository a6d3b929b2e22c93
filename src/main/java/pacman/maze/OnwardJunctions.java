package pacman.maze;

/**
 * Tables of the junctions beyond the next one: the moves that lead to them, the nodes on the paths, and the time at
 * which a ghost arrives there. The sensors that test whether a junction can be reached safely read them.
 *
 * <p>A row is a pair of the next junction and the move that enters it, numbered as in {@link Routes}. A row has four
 * lanes, numbered by the moves 0 to 3 at its junction. The target of a lane is the junction that the move leads to; the
 * path to it is an onward path. No path leads back, so the lane of the way back stands for the row's own junction. A
 * lane of a wall has no target; methods that return sets may contain it, so combine them with {@link #moves} or {@link
 * #ownBit}.
 *
 * <p>Methods return sets of lanes in one of two forms. <em>Bits</em> are an int with bit m for lane m. <em>Flags</em>
 * are a long with bit 16 m + 15 for lane m: this form can be computed for four lanes at once. {@link #flags} turns bits
 * into flags. A <em>place</em> is the position of a node in the form of {@link Routes#place}.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 4.10.
 */
public final class OnwardJunctions {

    /*
     * From the next junction on everything depends only on the row, that is, on this junction and the move that enters
     * it. A row has four lanes, one per move at its junction: the lane's target is the junction that the move leads to.
     * The move that leads back is none to go on by; its lane stands for the row's own junction instead. So one long
     * holds what is to be known of all targets, 16 bits each, and one addition and one mask compare all of them (flags,
     * at the top of each lane):
     *
     *   arrivals   who needs how long: for a row of Ms. Pac-Man's and one of a ghost's, the ghost's steps less hers;
     *   lengths    her steps from the row's junction to the target;
     *   onPaths    for a row and a segment: the lanes whose path passes the corridor or junction, and those whose
     *   target it is; within     for both rows: the lanes where the ghost's path to the target lies on hers.
     */

    /** The top bit of each lane. */
    private static final long FLAGS = 0x8000_8000_8000_8000L;

    /** 1 in each lane. */
    private static final long ONES = 0x0001_0001_0001_0001L;

    /** Flags of lanes that are given as four bits. */
    private static final long[] FLAGS_OF_BITS = new long[16];

    private static final int LANE_BITS = 16;
    private static final int FLAG = 0x8000;

    /** In a lane without target: a number of steps that is never read. */
    private static final int NEVER = 0x3FFF;

    /** Numbers to compare with, as far as they are told apart. */
    private static final int MOST = 0x3000;

    static {
        for (int bits = 0; bits < 16; bits++) {
            for (int lane = 0; lane < 4; lane++) {
                FLAGS_OF_BITS[bits] |= (bits >> lane & 1L) * FLAG << LANE_BITS * lane;
            }
        }
    }

    private final MazeGraph graph;
    private final Routes routes;
    private final MazePaths paths;
    private final int rows;
    private final int segments;

    /** Target of lane m of row r, at index 4 r + m, or -1. */
    private final int[] targets;

    /** Steps of the path from row r's junction to there, at index 4 r + m. */
    private final int[] steps;

    /** Steps of the longest of a row's paths. */
    private final int[] longest;

    /** Per lane, {@link #FLAG} plus the steps. */
    private final long[] lengths;

    /** Per lane, {@link #FLAG} plus her steps less a ghost's, at index rows r + ghost's row. */
    private final long[] arrivals;

    /** The same for the ghosts' way from where they leave the lair. */
    private final long[] arrivalsFromLair;

    /** Bits of lanes, at index rows r + ghost's row. */
    private final byte[] within;

    /**
     * Bits of lanes whose path passes segment s, and from bit 4 on of those whose target it is, at index segments r +
     * s. A path from junction to junction has all nodes of a corridor or none.
     */
    private final byte[] onPaths;

    /**
     * Moves, as bits, that lead on from the next junction and not back, for node v and direction d at index 4 v + d.
     */
    private final byte[] moves;

    /** The onward paths of a maze. */
    public OnwardJunctions(MazeTables maze) {
        this.graph = maze.graph();
        paths = maze.paths();
        routes = paths.routes();
        rows = routes.rowCount();
        segments = routes.segmentCount();
        targets = new int[4 * rows];
        steps = new int[4 * rows];
        longest = new int[rows];
        lengths = new long[rows];
        arrivals = new long[rows * rows];
        arrivalsFromLair = new long[rows];
        within = new byte[rows * rows];
        onPaths = new byte[rows * routes.segmentCount()];
        moves = new byte[4 * graph.nodeCount()];
        int[] path = new int[MazePaths.LONGEST * graph.nodeCount()];
        for (int row = 0; row < rows; row++) {
            // Every path passes the row's own junction.
            onPaths[index(row, routes.place(routes.junctionOfRow(row)))] = 0xF;
            for (int lane = 0; lane < 4; lane++) {
                findPath(row, lane, path);
            }
            for (int lane = 0; lane < 4; lane++) {
                fillLane(maze, row, lane, path);
            }
        }
        for (int v = 0; v < graph.lair(); v++) {
            for (int d = 0; d < 4; d++) {
                if (graph.isOpen(v, d)) {
                    moves[4 * v + d] = (byte) movesOn(v, d);
                }
            }
        }
    }

    private void findPath(int row, int lane, int[] path) {
        int from = routes.junctionOfRow(row);
        int index = 4 * row + lane;
        if (lane == ownLane(row)) {
            targets[index] = from;
        } else if (graph.isOpen(from, lane)) {
            targets[index] = routes.junction(routes.leaving(from, lane));
            steps[index] = paths.rowPath(row, targets[index], path, 0);
            longest[row] = Math.max(longest[row], steps[index]);
            for (int i = 0; i < steps[index]; i++) {
                onPaths[index(row, routes.place(path[i]))] |= (byte) (1 << lane);
            }
        } else {
            targets[index] = MazeGraph.NONE;
            return;
        }
        onPaths[index(row, routes.place(targets[index]))] |= (byte) (0x10 << lane);
    }

    private void fillLane(MazeTables maze, int row, int lane, int[] path) {
        int index = 4 * row + lane;
        int target = targets[index];
        boolean exists = target != MazeGraph.NONE;
        int shift = LANE_BITS * lane;
        lengths[row] |= (long) (FLAG + steps[index]) << shift;
        int fromLair = exists ? maze.distances().between(graph.ghostStart(), target) : NEVER;
        arrivalsFromLair[row] |= (long) (FLAG + steps[index] - fromLair) << shift;
        for (int other = 0; other < rows; other++) {
            int needed = exists ? paths.rowLength(other, target) : NEVER;
            arrivals[row * rows + other] |= (long) (FLAG + steps[index] - needed) << shift;
            if (exists && isWithin(row, lane, other, path)) {
                within[row * rows + other] |= (byte) (1 << lane);
            }
        }
    }

    /** Whether another row's junction and its path to the lane's target lie on the path to there. */
    private boolean isWithin(int row, int lane, int other, int[] path) {
        if (!isOnward(row, lane, routes.junctionOfRow(other))) {
            return false;
        }
        int length = paths.rowPath(other, targets[4 * row + lane], path, 0);
        for (int i = 0; i < length; i++) {
            if (!isOnward(row, lane, path[i])) {
                return false;
            }
        }
        return true;
    }

    private boolean isOnward(int row, int lane, int node) {
        return (passing(row, routes.place(node)) >> lane & 1) != 0;
    }

    private int movesOn(int node, int direction) {
        int next = routes.junction(routes.leaving(node, direction));
        int bits = 0;
        for (int m = 0; m < 4; m++) {
            if (graph.isOpen(next, m)) {
                long route = routes.leaving(next, m);
                // The way back is excluded because she is on it or at its end.
                if (routes.junction(route) != node && routes.ahead(route, node) < 0) {
                    bits |= 1 << m;
                }
            }
        }
        return bits;
    }

    private int ownLane(int row) {
        return MazeGraph.opposite(routes.arrivalOfRow(row));
    }

    /** Moves, as bits, that lead on from the next junction in a direction. */
    public int moves(int node, int direction) {
        return moves[4 * node + direction];
    }

    /** The bit of the lane that stands for the row's own junction. */
    public int ownBit(int row) {
        return 1 << ownLane(row);
    }

    /** Junction that a lane stands for. */
    public int target(int row, int lane) {
        return targets[4 * row + lane];
    }

    /** Steps from the row's junction to a lane's. */
    public int length(int row, int lane) {
        return steps[4 * row + lane];
    }

    /** Steps of the longest onward path of a row. */
    public int longest(int row) {
        return longest[row];
    }

    /**
     * Bits of the lanes whose onward path passes a place. The row's own junction lies on every path: for its place, all
     * four bits are set.
     */
    public int passing(int row, int place) {
        return onPaths[index(row, place)] & 0xF;
    }

    /** Bits of the lanes that stand for the junction at a place. */
    public int endingAt(int row, int place) {
        return onPaths[index(row, place)] >> 4 & 0xF;
    }

    private int index(int row, int place) {
        return row * segments + Routes.segment(place);
    }

    /**
     * Bits of the lanes for which a walker at another row's junction stays on the row's onward path: that junction and
     * all nodes of the walker's own path to the lane's target lie on it.
     *
     * @param row the row of Ms. Pac-Man
     * @param other the row of the ghost
     */
    public int within(int row, int other) {
        return within[row * rows + other];
    }

    /** Returns a set of lanes that is given as bits, 0 to 15, in the form of flags. */
    public static long flags(int bits) {
        return FLAGS_OF_BITS[bits];
    }

    /**
     * Flags of the lanes whose target is at most {@code more} steps farther from another row's junction than from the
     * row's own.
     *
     * @param row the row of Ms. Pac-Man
     * @param other the row of the ghost
     * @param more difference in steps; negative if the ghost must be nearer
     */
    public long arriving(int row, int other, int more) {
        return arrivals[row * rows + other] + ONES * Math.max(more, -MOST) & FLAGS;
    }

    /** As {@link #arriving}, for a ghost that starts at the exit of the lair. */
    public long arrivingFromLair(int row, int more) {
        return arrivalsFromLair[row] + ONES * Math.max(more, -MOST) & FLAGS;
    }

    /** Flags of the lanes whose onward path has at least {@code length} steps. */
    public long atLeast(int row, int length) {
        return lengths[row] - ONES * Math.max(Math.min(length, MOST), -MOST) & FLAGS;
    }
}
