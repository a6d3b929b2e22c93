package mmneat.mspacman.sensors;

import static mmneat.mspacman.sensors.CorridorPositions.NONE;

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

    private final Situation situation;
    private SensorTables tables;
    private PathTables paths;
    private Ways ways;

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

    SafetyTest(Situation situation) {
        this.situation = situation;
    }

    /**
     * Number of moves at the next junction that lead safely to another junction than where she comes from; 0 if the next
     * junction itself is not safe.
     */
    int options() {
        tables = situation.tables();
        paths = tables.paths;
        ways = tables.ways;
        long way = situation.way();
        target = ways.junction(way);
        steps = Ways.steps(way);
        onward = NONE;
        int row = Ways.row(way);
        int moves = tables.onward.moves(situation.pacManNode(), situation.direction());
        int mostSteps = steps + tables.onward.longest(row);
        mayGoToLastPill =
                situation.powerPillsLeft() == 0 && situation.pillsLeft() > 0 && situation.pillsLeft() <= mostSteps;
        if (mostSteps <= situation.harmlessSteps() && !mayGoToLastPill) {
            return Integer.bitCount(moves);
        }
        return isSafe() ? safeMoves(way, row, moves) : 0;
    }

    private int safeMoves(long way, int row, int onwardMoves) {
        int options = 0;
        for (int moves = onwardMoves; moves != 0; moves &= moves - 1) {
            onward = OnwardJunctions.path(row, Integer.numberOfTrailingZeros(moves));
            target = tables.onward.end(onward);
            steps = Ways.steps(way) + tables.onward.length(onward);
            if (isSafe()) {
                options++;
            }
        }
        return options;
    }

    /** Number of steps of her path up to which a ghost cannot stop her by any rule below; -1 for threats. */
    int harmlessSteps(int ghost) {
        if (!situation.isOutside(ghost)) {
            return situation.lairTime(ghost);
        }
        int edibleTime = situation.edibleTime(ghost);
        // The ghost's own path to her is not shorter than the distance that counts when they meet.
        return edibleTime > 0 && timeToMeet(situation.ghostPathLength(ghost)) < edibleTime ? edibleTime - 1 : -1;
    }

    private boolean isSafe() {
        isStamped = false;
        if (mayGoToLastPill && situation.pillsLeft() <= steps) {
            goOnlyToLastPill();
        }
        for (int ghost = 0; ghost < Situation.GHOSTS; ghost++) {
            boolean stops;
            if (!situation.isOutside(ghost)) {
                stops = stopsFromLair(situation.lairTime(ghost));
            } else if (situation.isEdible(ghost)) {
                stops = stopsWhileEdible(ghost, situation.edibleTime(ghost));
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
        int node = situation.ghostNode(ghost);
        if (node == target && !situation.isApproaching(ghost)) {
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
        if (steps <= situation.harmlessSteps(ghost)) {
            return false;
        }
        int node = situation.ghostNode(ghost);
        if (isGhostOnPath(ghost, node)) {
            if (runsAhead(ghost, node)) {
                return false;
            }
            int distance = tables.distances.between(node, situation.pacManNode());
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
                ? paths.length(situation.ghostWay(ghost), 0, target)
                : paths.lengthBeyond(situation.ghostWay(ghost), target);
    }

    /** Both lengths as the simulator's paths have them. */
    private boolean headsForPacMan(int ghost, int node) {
        return situation.ghostPathLength(ghost) == paths.undirectedLength(node, situation.pacManNode());
    }

    private boolean isGhostOnPath(int ghost, int node) {
        if (isStamped) {
            return stamps[node] == stamp;
        }
        return situation.isInCorridorAhead(ghost)
                || node == ways.junction(situation.way())
                || onward != NONE && tables.onward.passes(onward, node);
    }

    private boolean isOnPath(int node) {
        if (isStamped) {
            return stamps[node] == stamp;
        }
        return ways.ahead(situation.way(), node) > 0
                || node == ways.junction(situation.way())
                || onward != NONE && tables.onward.passes(onward, node);
    }

    /** Whether a ghost on her path, but not on a junction, goes to the target along her path. */
    private boolean runsAhead(int ghost, int node) {
        if (tables.graph.isJunction(node)) {
            return false;
        }
        long ghostWay = situation.ghostWay(ghost);
        if (!isStamped && situation.isInCorridorAhead(ghost)) {
            if (Ways.isSameCourse(ghostWay, situation.way())) {
                return true;
            }
            // It comes towards her, and so passes her.
            if (!isOnPath(situation.pacManNode())) {
                return false;
            }
        }
        return isWithinPath(ghostWay);
    }

    private boolean isWithinPath(long ghostWay) {
        int ahead = ways.ahead(ghostWay, target);
        boolean inCorridor = ahead >= 0;
        int legSteps = inCorridor ? ahead : Ways.steps(ghostWay);
        for (int step = 1; step <= legSteps; step++) {
            boolean isEnd = step == legSteps && !inCorridor;
            if (!isOnPath(isEnd ? ways.junction(ghostWay) : ways.corridorNode(ghostWay, step))) {
                return false;
            }
        }
        if (inCorridor) {
            return true;
        }
        makeRoom();
        int length = paths.rowPath(Ways.row(ghostWay), target, path, 0);
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
            for (long left = situation.activePills(word); left != 0; left &= left - 1) {
                int pill = tables.graph.pillNode(64 * word + Long.numberOfTrailingZeros(left));
                if (stamps[pill] != stamp) {
                    return;
                }
                int length = paths.length(situation.way(), situation.least(), pill);
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
        int length = paths.path(situation.way(), situation.least(), end, path);
        for (int i = 0; i < length; i++) {
            stamps[path[i]] = stamp;
        }
    }
}
