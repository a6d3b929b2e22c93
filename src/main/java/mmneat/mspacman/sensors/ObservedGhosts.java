package mmneat.mspacman.sensors;

import pacman.maze.ApproachTables;
import pacman.maze.MazePaths;
import pacman.maze.Routes;

/**
 * The ghosts of an observation: where they are, how they come to Ms.&nbsp;Pac-Man, and how far they are in the
 * direction that she faces.
 *
 * <p>Distances are along the simulator's paths. Routes, places, paths and distances exist for ghosts outside the lair
 * only.
 */
final class ObservedGhosts {

    private static final int GHOSTS = Observation.GHOSTS;

    /** Distance minus 1, in a sort key, of a ghost that has no distance. */
    private static final int FARTHEST = (1 << 28) - 1;

    @SuppressWarnings("NullAway.Init")
    private SensorTables tables;

    @SuppressWarnings("NullAway.Init")
    private MazePaths paths;

    @SuppressWarnings("NullAway.Init")
    private Routes routes;

    // The state.
    private final int[] node = new int[GHOSTS];
    private final int[] edibleTime = new int[GHOSTS];
    private final int[] lairTime = new int[GHOSTS];
    private final long[] route = new long[GHOSTS];

    // Values that are computed from the state.
    private int pacManNode;
    private final int[] place = new int[GHOSTS];
    private final int[] pathLength = new int[GHOSTS];
    private final int[] neighboursPassed = new int[GHOSTS];

    /** Whether each ghost heads for her; valid if its bit is set in {@link #headingKnown}, and computed on request. */
    private final boolean[] heading = new boolean[GHOSTS];

    private int headingKnown;
    private int highestEdibleTime;
    private int edibleCount;
    private int threats;

    // Values that are computed from the direction.
    private int direction;
    private int least;
    private final int[] distance = new int[GHOSTS];
    private final int[] stepsAhead = new int[GHOSTS];

    /** Distance and number of each ghost outside the lair, nearest first. */
    private final int[] orderKeys = new int[GHOSTS];

    private int outside;

    /** Sets the maze. */
    void enter(SensorTables maze) {
        tables = maze;
        paths = maze.paths;
        routes = maze.routes;
    }

    /**
     * Sets a ghost.
     *
     * @param lastMove 0 to 3, or 4 for none
     */
    void place(int ghost, int atNode, int edible, int lair, int lastMove) {
        node[ghost] = atNode;
        edibleTime[ghost] = edible;
        lairTime[ghost] = lair;
        route[ghost] = lair > 0 ? 0 : routes.continuing(atNode, lastMove);
    }

    /** Computes the values that depend only on the state; call it when all ghosts are set. */
    void conclude(int nodeOfPacMan) {
        pacManNode = nodeOfPacMan;
        headingKnown = 0;
        highestEdibleTime = 0;
        edibleCount = 0;
        threats = 0;
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            highestEdibleTime = Math.max(highestEdibleTime, edibleTime[ghost]);
            if (isEdible(ghost)) {
                edibleCount++;
            } else if (isThreat(ghost)) {
                threats++;
            }
            if (isOutside(ghost)) {
                int approach = tables.approaches.approach(route[ghost], nodeOfPacMan);
                pathLength[ghost] = ApproachTables.lengthOf(approach);
                neighboursPassed[ghost] = ApproachTables.neighboursOf(approach);
                place[ghost] = routes.place(node[ghost]);
            }
        }
    }

    /**
     * Sets the direction that she faces, and computes the values that depend on it.
     *
     * @param herRoute how she leaves her node
     * @param leastSteps 0 if a target on her own node is reached by no step, 1 if only by a way around
     */
    void face(int newDirection, long herRoute, int leastSteps) {
        direction = newDirection;
        least = leastSteps;
        outside = 0;
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            orderKeys[ghost] = Integer.MAX_VALUE;
            if (isOutside(ghost)) {
                int ahead = Routes.aheadOfPlace(herRoute, place[ghost]);
                int steps = ahead >= leastSteps
                        ? ahead
                        : Routes.steps(herRoute) + paths.lengthToPlace(Routes.row(herRoute), place[ghost]);
                stepsAhead[ghost] = ahead;
                distance[ghost] = steps;
                orderKeys[ghost] = (steps - 1 & FARTHEST) << 2 | ghost;
                outside++;
            }
        }
        order();
    }

    /*
     * Sorts by distance, then by number; a ghost without distance comes after those with one, and ghosts in the lair
     * come last. Five comparisons sort four keys. They are written as minimum and maximum, without branches, which the
     * processor could not predict.
     */
    private void order() {
        int a = Math.min(orderKeys[0], orderKeys[1]);
        int b = Math.max(orderKeys[0], orderKeys[1]);
        int c = Math.min(orderKeys[2], orderKeys[3]);
        int d = Math.max(orderKeys[2], orderKeys[3]);
        int inner = Math.max(a, c);
        int other = Math.min(b, d);
        orderKeys[0] = Math.min(a, c);
        orderKeys[1] = Math.min(inner, other);
        orderKeys[2] = Math.max(inner, other);
        orderKeys[3] = Math.max(b, d);
    }

    int node(int ghost) {
        return node[ghost];
    }

    int edibleTime(int ghost) {
        return edibleTime[ghost];
    }

    int lairTime(int ghost) {
        return lairTime[ghost];
    }

    boolean isOutside(int ghost) {
        return lairTime[ghost] == 0;
    }

    boolean isEdible(int ghost) {
        return edibleTime[ghost] > 0;
    }

    boolean isThreat(int ghost) {
        return edibleTime[ghost] == 0 && node[ghost] != tables.graph.lair();
    }

    /** Number of edible ghosts. */
    int edibleCount() {
        return edibleCount;
    }

    int threats() {
        return threats;
    }

    int highestEdibleTime() {
        return highestEdibleTime;
    }

    /** The route of a ghost, as {@link Routes} encodes it. */
    long route(int ghost) {
        return route[ghost];
    }

    /** Place of a ghost, as {@link Routes#place} numbers it. */
    int place(int ghost) {
        return place[ghost];
    }

    /** Steps of a ghost's own path to Ms. Pac-Man. */
    int pathLength(int ghost) {
        return pathLength[ghost];
    }

    /** Whether a ghost takes the shortest path to Ms. Pac-Man; both lengths as the simulator has them. */
    boolean headsForPacMan(int ghost) {
        if ((headingKnown >> ghost & 1) == 0) {
            headingKnown |= 1 << ghost;
            heading[ghost] = pathLength[ghost] == paths.undirectedLength(node[ghost], pacManNode);
        }
        return heading[ghost];
    }

    /** The nth nearest ghost, or -1 if there are no more than n. */
    int nthNearest(int n) {
        return n < outside ? orderKeys[n] & 3 : -1;
    }

    /** The nth nearest of the ghosts that are edible, or of those that are not; -1 if there are no more than n. */
    int nthNearest(int n, boolean edible) {
        int left = n;
        for (int position = 0; position < outside; position++) {
            int ghost = orderKeys[position] & 3;
            if (isEdible(ghost) == edible && left-- == 0) {
                return ghost;
            }
        }
        return -1;
    }

    /** Steps to a ghost. */
    int distance(int ghost) {
        return distance[ghost];
    }

    /** Steps to a ghost in the corridor ahead, 0 for one on her node in a straight corridor; else below 0. */
    int stepsAhead(int ghost) {
        return stepsAhead[ghost];
    }

    boolean isApproaching(int ghost) {
        return (neighboursPassed[ghost] >> direction & 1) != 0;
    }

    boolean isTrapped(int ghost) {
        return stepsAhead[ghost] >= least;
    }

    /**
     * Flags of a ghost: bit 0 approaching, bit 1 trapped, bit 2 edible. They are computed without branches, which the
     * processor could not predict.
     */
    int flags(int ghost) {
        return neighboursPassed[ghost] >> direction & 1
                | (least - 1 - stepsAhead[ghost]) >>> 30 & 2
                | -edibleTime[ghost] >>> 29 & 4;
    }
}
