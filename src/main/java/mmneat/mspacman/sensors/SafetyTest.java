package mmneat.mspacman.sensors;

import static pacman.maze.CorridorPositions.NONE;

import pacman.maze.OnwardJunctions;
import pacman.maze.PathTables;
import pacman.maze.Routes;

/**
 * Which junctions Ms. Pac-Man can reach in the direction that is looked at before a ghost stops her.
 *
 * <p>Source: docs/specification/mspacman-task.md, sections 4.10 and 4.11, whose rules the methods follow.
 */
final class SafetyTest {

    /*
     * Her path to one of the junctions beyond the next one is her corridor, the next junction, and an onward path that is kept
     * as a set of nodes: whether a ghost is on her path is two comparisons and a bit. A ghost's own path is only written out
     * if it is on hers and neither simply runs ahead nor comes towards her; then the path is written into a scratch array.
     * The rule of the last pill, which asks for paths to any pill, writes out her own path too.
     */

    private static final int MEETING_DISTANCE = 2;

    private final Observation observation;
    private SensorTables tables;
    private PathTables paths;
    private Routes routes;

    /** Ms. Pac-Man's path: its target, its steps, and the onward path behind the next junction, NONE if it ends there. */
    private int target;

    private int steps;
    private int onward;

    /** Whether so few pills, and no power pills, are left that all may be on a path. */
    private boolean mayGoToLastPill;

    /** Whether her path ends anywhere, as for the last pill: then it is marked by stamps. */
    private boolean isStamped;

    /** A node is on the stamped path if its stamp is the current one. */
    private int[] stamps = new int[0];

    private int stamp;
    private int[] path = new int[0];

    SafetyTest(Observation observation) {
        this.observation = observation;
    }

    /**
     * Number of moves at the next junction that lead safely to another junction than where she comes from; 0 if the next
     * junction itself is not safe.
     */
    int options() {
        tables = observation.tables();
        paths = tables.paths;
        routes = tables.routes;
        long route = observation.route();
        target = routes.junction(route);
        steps = Routes.steps(route);
        onward = NONE;
        int row = Routes.row(route);
        int moves = tables.onward.moves(observation.pacManNode(), observation.direction());
        int mostSteps = steps + tables.onward.longest(row);
        mayGoToLastPill = observation.powerPillsLeft() == 0
                && observation.pillsLeft() > 0
                && observation.pillsLeft() <= mostSteps;
        if (mostSteps <= observation.harmlessSteps() && !mayGoToLastPill) {
            return Integer.bitCount(moves);
        }
        return isSafe() ? safeMoves(route, row, moves) : 0;
    }

    private int safeMoves(long route, int row, int onwardMoves) {
        int options = 0;
        for (int moves = onwardMoves; moves != 0; moves &= moves - 1) {
            onward = OnwardJunctions.path(row, Integer.numberOfTrailingZeros(moves));
            target = tables.onward.end(onward);
            steps = Routes.steps(route) + tables.onward.length(onward);
            if (isSafe()) {
                options++;
            }
        }
        return options;
    }

    /** Number of steps of her path up to which a ghost cannot stop her by any rule below; -1 for threats. */
    int harmlessSteps(int ghost) {
        if (!observation.isOutside(ghost)) {
            return observation.lairTime(ghost);
        }
        int edibleTime = observation.edibleTime(ghost);
        // The ghost's own path to her is not shorter than the distance that counts when they meet.
        return edibleTime > 0 && timeToMeet(observation.ghostPathLength(ghost)) < edibleTime ? edibleTime - 1 : -1;
    }

    private boolean isSafe() {
        isStamped = false;
        if (mayGoToLastPill && observation.pillsLeft() <= steps) {
            goOnlyToLastPill();
        }
        for (int ghost = 0; ghost < Observation.GHOSTS; ghost++) {
            boolean stops;
            if (!observation.isOutside(ghost)) {
                stops = stopsFromLair(observation.lairTime(ghost));
            } else if (observation.isEdible(ghost)) {
                stops = stopsWhileEdible(ghost, observation.edibleTime(ghost));
            } else {
                stops = stopsAsThreat(ghost);
            }
            if (stops) {
                return false;
            }
        }
        return true;
    }

    private boolean stopsFromLair(int lairTime) {
        return lairTime < steps && tables.fromLairExit[target] + lairTime - MEETING_DISTANCE <= steps;
    }

    private boolean stopsAsThreat(int ghost) {
        int node = observation.ghostNode(ghost);
        if (node == target && !observation.isApproaching(ghost)) {
            return false;
        }
        if (isGhostOnPath(ghost, node)) {
            if (runsAhead(ghost, node)) {
                return false;
            }
            if (headsForPacMan(ghost, node)) {
                return true;
            }
        }
        return ghostSteps(ghost) - MEETING_DISTANCE <= steps;
    }

    private boolean stopsWhileEdible(int ghost, int edibleTime) {
        if (steps <= observation.harmlessSteps(ghost)) {
            return false;
        }
        int node = observation.ghostNode(ghost);
        if (isGhostOnPath(ghost, node)) {
            if (runsAhead(ghost, node)) {
                return false;
            }
            int distance = tables.distances.between(node, observation.pacManNode());
            if (timeToMeet(distance) >= edibleTime && headsForPacMan(ghost, node)) {
                return true;
            }
        }
        return steps >= edibleTime && ghostSteps(ghost) + edibleTime - MEETING_DISTANCE <= steps;
    }

    /** Steps until Ms. Pac-Man and an edible ghost, at half her speed, meet. */
    private static int timeToMeet(int distance) {
        return 2 * ((distance - MEETING_DISTANCE) / 3);
    }

    private int ghostSteps(int ghost) {
        // Only pills can be in the ghost's own corridor: a junction is beyond it, or the place where it is.
        return isStamped
                ? paths.length(observation.ghostRoute(ghost), 0, target)
                : paths.lengthBeyond(observation.ghostRoute(ghost), target);
    }

    /** Both lengths as the simulator's paths have them. */
    private boolean headsForPacMan(int ghost, int node) {
        return observation.ghostPathLength(ghost) == paths.undirectedLength(node, observation.pacManNode());
    }

    private boolean isGhostOnPath(int ghost, int node) {
        if (isStamped) {
            return stamps[node] == stamp;
        }
        return observation.isInCorridorAhead(ghost)
                || node == routes.junction(observation.route())
                || onward != NONE && tables.onward.passes(onward, node);
    }

    private boolean isOnPath(int node) {
        if (isStamped) {
            return stamps[node] == stamp;
        }
        return routes.ahead(observation.route(), node) > 0
                || node == routes.junction(observation.route())
                || onward != NONE && tables.onward.passes(onward, node);
    }

    /** Whether a ghost on her path, but not on a junction, goes to the target along her path. */
    private boolean runsAhead(int ghost, int node) {
        if (tables.graph.isJunction(node)) {
            return false;
        }
        long ghostRoute = observation.ghostRoute(ghost);
        if (!isStamped && observation.isInCorridorAhead(ghost)) {
            if (Routes.isSameCourse(ghostRoute, observation.route())) {
                return true;
            }
            // It comes towards her, and so passes her.
            if (!isOnPath(observation.pacManNode())) {
                return false;
            }
        }
        return isWithinPath(ghostRoute);
    }

    private boolean isWithinPath(long ghostRoute) {
        int ahead = routes.ahead(ghostRoute, target);
        boolean inCorridor = ahead >= 0;
        int legSteps = inCorridor ? ahead : Routes.steps(ghostRoute);
        for (int step = 1; step <= legSteps; step++) {
            boolean isEnd = step == legSteps && !inCorridor;
            if (!isOnPath(isEnd ? routes.junction(ghostRoute) : routes.corridorNode(ghostRoute, step))) {
                return false;
            }
        }
        if (inCorridor) {
            return true;
        }
        makeRoom();
        int length = paths.rowPath(Routes.row(ghostRoute), target, path, 0);
        for (int i = 0; i < length; i++) {
            if (!isOnPath(path[i])) {
                return false;
            }
        }
        return true;
    }

    private void makeRoom() {
        int nodes = tables.graph.nodeCount();
        if (stamps.length < nodes) {
            stamps = new int[nodes];
            stamp = 0;
            path = new int[PathTables.LONGEST * nodes];
        }
    }

    /** Eating the last pill ends the level: if all pills are on her path and no power pill is left, it ends at the last. */
    private void goOnlyToLastPill() {
        stampPath(target);
        int last = NONE;
        int longest = -1;
        for (int word = 0; word < tables.graph.pillWords(); word++) {
            for (long left = observation.activePills(word); left != 0; left &= left - 1) {
                int pill = tables.graph.pillNode(64 * word + Long.numberOfTrailingZeros(left));
                if (stamps[pill] != stamp) {
                    return;
                }
                int length = paths.length(observation.route(), observation.least(), pill);
                if (length > longest) {
                    longest = length;
                    last = pill;
                }
            }
        }
        target = last;
        steps = longest;
        stampPath(last);
        isStamped = true;
    }

    private void stampPath(int end) {
        makeRoom();
        stamp++;
        int length = paths.path(observation.route(), observation.least(), end, path);
        for (int i = 0; i < length; i++) {
            stamps[path[i]] = stamp;
        }
    }
}
