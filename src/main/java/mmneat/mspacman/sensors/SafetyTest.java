package mmneat.mspacman.sensors;

import pacman.maze.MazePaths;
import pacman.maze.OnwardJunctions;
import pacman.maze.Routes;

/**
 * The test which junctions Ms. Pac-Man can reach in one direction before a ghost stops her.
 *
 * <p>Source: docs/specification/mspacman-task.md, sections 4.10 and 4.11, whose rules the methods follow.
 */
final class SafetyTest {

    /*
     * Targets are the next junction and those beyond it, four at most: the lanes of OnwardJunctions. Each rule is
     * evaluated once per ghost, for all targets together.
     *
     * Her path to a target is her corridor, the next junction, and an onward path. A ghost on it that is in a corridor
     * has the whole rest of that corridor on it, too. So the ghost's own path to the target stays on hers if and only
     * if it stays on the onward path from the end of its corridor on, which is looked up. That holds unless the onward
     * path comes by her own node. For such targets, and for the last pill as target, paths are written out and compared
     * node by node.
     */

    private static final int MEETING_DISTANCE = 2;

    private final Observation observation;
    private final ObservedGhosts ghosts;

    @SuppressWarnings("NullAway.Init")
    private SensorTables tables;

    @SuppressWarnings("NullAway.Init")
    private MazePaths paths;

    /** Ms. Pac-Man's route, its row, and the steps to the next junction. */
    private long route;

    private int row;
    private int toJunction;

    /** Per ghost, the number of steps in which it cannot stop her, wherever she goes; below 0 for threats. */
    private final int[] harmless = new int[Observation.GHOSTS];

    /** The least of them. */
    private int harmlessSteps;

    /** A node is on the path that was written out last if its stamp is the current one. */
    private int[] stamps = new int[0];

    private int stamp;
    private int[] path = new int[0];

    SafetyTest(Observation observation, ObservedGhosts ghosts) {
        this.observation = observation;
        this.ghosts = ghosts;
    }

    /** Computes the values that depend only on the state. */
    void conclude() {
        harmlessSteps = Integer.MAX_VALUE;
        for (int ghost = 0; ghost < Observation.GHOSTS; ghost++) {
            harmless[ghost] = harmlessSteps(ghost);
            harmlessSteps = Math.min(harmlessSteps, harmless[ghost]);
        }
    }

    /**
     * Number of moves at the next junction that lead safely to another junction than where she comes from; 0 if the
     * next junction itself is not safe.
     */
    int options() {
        tables = observation.tables();
        paths = tables.paths;
        route = observation.route();
        row = Routes.row(route);
        toJunction = Routes.steps(route);
        OnwardJunctions onward = tables.onward;
        int moves = onward.moves(observation.pacManNode(), observation.direction());
        int mostSteps = toJunction + onward.longest(row);
        boolean mayReachLastPill = observation.powerPillsLeft() == 0
                && observation.pillsLeft() > 0
                && observation.pillsLeft() <= mostSteps;
        if (mostSteps <= harmlessSteps && !mayReachLastPill) {
            return Integer.bitCount(moves);
        }
        int targets = moves | onward.ownBit(row);
        int special = targets & onward.passing(row, tables.routes.place(observation.pacManNode()));
        if (mayReachLastPill) {
            special |= targets & passingAllPills();
        }
        long junction = OnwardJunctions.flags(onward.ownBit(row));
        long ordinary = OnwardJunctions.flags(targets & ~special);
        long safe = withoutStopped(ordinary, junction & ordinary, mostSteps);
        for (int lanes = special; lanes != 0; lanes &= lanes - 1) {
            int lane = Integer.numberOfTrailingZeros(lanes);
            if (isSafe(onward.target(row, lane), toJunction + onward.length(row, lane))) {
                safe |= OnwardJunctions.flags(1 << lane);
            }
        }
        return (safe & junction) == 0 ? 0 : Long.bitCount(safe) - 1;
    }

    /** Number of steps of her path up to which a ghost cannot stop her by any rule below; -1 for threats. */
    private int harmlessSteps(int ghost) {
        if (!ghosts.isOutside(ghost)) {
            return ghosts.lairTime(ghost);
        }
        int edibleTime = ghosts.edibleTime(ghost);
        // The ghost's own path to her is not shorter than the distance that counts when they meet.
        return edibleTime > 0 && timeToMeet(ghosts.pathLength(ghost)) < edibleTime ? edibleTime - 1 : -1;
    }

    // ---- All targets together ----

    /**
     * Takes from the flags of targets those before which a ghost stops her.
     *
     * @param required without these the others do not count, and may be left as they are
     * @param mostSteps of the longest path
     */
    private long withoutStopped(long targets, long required, int mostSteps) {
        long stopped = 0;
        int ghostsOnPaths = 0;
        for (int ghost = 0; ghost < Observation.GHOSTS; ghost++) {
            if (harmless[ghost] >= mostSteps) {
                continue;
            }
            if (ghosts.isOutside(ghost)) {
                // 1 if the ghost is on one of her paths: without a branch, which could not be predicted.
                int isOnPath = -onPaths(ghost) >>> 31;
                ghostsOnPaths |= isOnPath << ghost;
                stopped |= arrivesFirst(ghost) & isOnPath - 1L;
            } else {
                stopped |= stoppedFromLair(ghosts.lairTime(ghost));
            }
        }
        long safe = targets & ~stopped;
        for (int left = ghostsOnPaths; left != 0 && (safe & required) == required; left &= left - 1) {
            safe &= ~stoppedOnPath(Integer.numberOfTrailingZeros(left), safe);
        }
        return safe;
    }

    private long stoppedFromLair(int lairTime) {
        return tables.onward.atLeast(row, lairTime + 1 - toJunction)
                & tables.onward.arrivingFromLair(row, toJunction + MEETING_DISTANCE - lairTime);
    }

    /** Flags of the targets at which a ghost outside the lair can be, no longer edible, when she comes. */
    private long arrivesFirst(int ghost) {
        int edibleTime = ghosts.edibleTime(ghost);
        long ghostRoute = ghosts.route(ghost);
        int more = toJunction + MEETING_DISTANCE - Routes.steps(ghostRoute) - edibleTime;
        long arrives = tables.onward.arriving(row, Routes.row(ghostRoute), more);
        return edibleTime == 0 ? arrives : arrives & tables.onward.atLeast(row, edibleTime - toJunction);
    }

    /** Bits of the targets to which her path passes a ghost; all if it is before the next junction. */
    private int onPaths(int ghost) {
        int inCorridor = -Math.max(ghosts.stepsAhead(ghost), 0) >>> 28;
        return inCorridor | tables.onward.passing(row, ghosts.place(ghost));
    }

    /**
     * Flags of the targets before which a ghost on her paths to some of them stops her.
     *
     * @param asked flags of the targets of interest
     */
    private long stoppedOnPath(int ghost, long asked) {
        int node = ghosts.node(ghost);
        long ghostRoute = ghosts.route(ghost);
        int edibleTime = ghosts.edibleTime(ghost);
        long onPaths = OnwardJunctions.flags(onPaths(ghost));
        long passed = 0;
        if (ghosts.stepsAhead(ghost) > 0) {
            if (Routes.isSameCourse(ghostRoute, route)) {
                return 0;
            }
        } else if (!tables.graph.isJunction(node)) {
            passed = OnwardJunctions.flags(tables.onward.within(row, Routes.row(ghostRoute))) & onPaths;
        } else if (edibleTime == 0 && !ghosts.isApproaching(ghost)) {
            passed = OnwardJunctions.flags(tables.onward.endingAt(row, ghosts.place(ghost)));
        }
        long stopped = arrivesFirst(ghost) & ~passed;
        long inTheWay = onPaths & ~passed;
        return (inTheWay & ~stopped & asked) != 0 && meetsAsThreat(ghost, edibleTime) ? stopped | inTheWay : stopped;
    }

    /** Whether a ghost heads for her and is no longer edible when they meet. */
    private boolean meetsAsThreat(int ghost, int edibleTime) {
        return (edibleTime == 0
                        || timeToMeet(tables.distances.between(ghosts.node(ghost), observation.pacManNode()))
                                >= edibleTime)
                && ghosts.headsForPacMan(ghost);
    }

    /** Steps until Ms. Pac-Man and an edible ghost, at half her speed, meet. */
    private static int timeToMeet(int distance) {
        return 2 * ((distance - MEETING_DISTANCE) / 3);
    }

    /** Bits of the targets to which her path passes all pills that are left. */
    private int passingAllPills() {
        int passing = 0xF;
        for (int word = 0; word < tables.graph.pillWords(); word++) {
            for (long left = observation.activePills(word); left != 0 && passing != 0; left &= left - 1) {
                int place = tables.routes.place(tables.graph.pillNode(64 * word + Long.numberOfTrailingZeros(left)));
                if (Routes.aheadOfPlace(route, place) <= 0) {
                    passing &= tables.onward.passing(row, place);
                }
            }
        }
        return passing;
    }

    // ---- One target, with paths written out ----

    private boolean isSafe(int junction, int stepsToJunction) {
        int target = junction;
        int steps = stepsToJunction;
        stampPath(target);
        if (observation.powerPillsLeft() == 0 && observation.pillsLeft() > 0) {
            // Eating the last pill ends the level: if all pills are on her path, it ends at the last.
            int last = lastPillOnPath();
            if (last >= 0) {
                target = last;
                steps = paths.length(route, observation.least(), last);
                stampPath(last);
            }
        }
        for (int ghost = 0; ghost < Observation.GHOSTS; ghost++) {
            if (stops(ghost, target, steps)) {
                return false;
            }
        }
        return true;
    }

    /** The last pill on the stamped path if all that are left are on it, else -1. */
    private int lastPillOnPath() {
        int last = -1;
        int longest = -1;
        for (int word = 0; word < tables.graph.pillWords(); word++) {
            for (long left = observation.activePills(word); left != 0; left &= left - 1) {
                int pill = tables.graph.pillNode(64 * word + Long.numberOfTrailingZeros(left));
                if (stamps[pill] != stamp) {
                    return -1;
                }
                int length = paths.length(route, observation.least(), pill);
                if (length > longest) {
                    longest = length;
                    last = pill;
                }
            }
        }
        return last;
    }

    private boolean stops(int ghost, int target, int steps) {
        if (!ghosts.isOutside(ghost)) {
            int lairTime = ghosts.lairTime(ghost);
            return lairTime < steps && tables.fromLairExit[target] + lairTime - MEETING_DISTANCE <= steps;
        }
        int node = ghosts.node(ghost);
        int edibleTime = ghosts.edibleTime(ghost);
        if (edibleTime == 0 && node == target && !ghosts.isApproaching(ghost)) {
            return false;
        }
        if (stamps[node] == stamp) {
            if (!tables.graph.isJunction(node) && isWithinPath(ghosts.route(ghost), target)) {
                return false;
            }
            if (meetsAsThreat(ghost, edibleTime)) {
                return true;
            }
        }
        int ghostSteps = paths.length(ghosts.route(ghost), 0, target);
        return steps >= edibleTime && ghostSteps + edibleTime - MEETING_DISTANCE <= steps;
    }

    private boolean isWithinPath(long ghostRoute, int target) {
        int length = paths.path(ghostRoute, 0, target, path);
        for (int i = 0; i < length; i++) {
            if (stamps[path[i]] != stamp) {
                return false;
            }
        }
        return true;
    }

    private void stampPath(int end) {
        int nodes = tables.graph.nodeCount();
        if (stamps.length < nodes) {
            stamps = new int[nodes];
            stamp = 0;
            path = new int[MazePaths.LONGEST * nodes];
        }
        stamp++;
        int length = paths.path(route, observation.least(), end, path);
        for (int i = 0; i < length; i++) {
            stamps[path[i]] = stamp;
        }
    }
}
