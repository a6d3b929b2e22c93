package pacman.game;

import org.jspecify.annotations.Nullable;
import pacman.game.Constants.DM;
import pacman.game.Constants.MOVE;
import pacman.game.GameRules.Conventions;
import pacman.maze.MazeGraph;
import pacman.maze.MazeTables;

/**
 * Queries of distances, moves and nearest nodes in a maze.
 *
 * <p>Move queries compare the neighbours of a node in the order up, right, down, left; at a tie the first neighbour is
 * chosen.
 *
 * <p>Source: docs/specification/simulator.md, sections 4.1 and 4.2.
 */
final class MoveQueries {

    private static final MOVE[] MOVES = MOVE.values();

    private MoveQueries() {}

    static int pathDistance(MazeTables tables, int from, int to) {
        if (Math.min(from, to) == -1 && Math.max(from, to) > 0) {
            // Quirk of the original: node -1 reads the table cell before the other node's row, which is always 0.
            requireNode(tables, Math.max(from, to));
            return 0;
        }
        requireNode(tables, from);
        requireNode(tables, to);
        return tables.distances().between(from, to);
    }

    /** Checks a node, because the tables of pairs also have entries for some invalid nodes. */
    static void requireNode(MazeTables tables, int node) {
        if (node < 0 || node >= tables.graph().nodeCount()) {
            throw new ArrayIndexOutOfBoundsException(node);
        }
    }

    static double euclideanDistance(MazeGraph graph, int from, int to) {
        int dx = graph.x(from) - graph.x(to);
        int dy = graph.y(from) - graph.y(to);
        return Math.sqrt((double) (dx * dx + dy * dy));
    }

    static int manhattanDistance(MazeGraph graph, int from, int to) {
        return Math.abs(graph.x(from) - graph.x(to)) + Math.abs(graph.y(from) - graph.y(to));
    }

    static double distance(MazeTables tables, int from, int to, DM metric) {
        switch (metric) {
            case PATH:
                return pathDistance(tables, from, to);
            case EUCLID:
                return euclideanDistance(tables.graph(), from, to);
            default:
                return manhattanDistance(tables.graph(), from, to);
        }
    }

    /** Distance without turning back; this only affects path distance. */
    static double distance(MazeTables tables, int from, int to, int lastMove, DM metric) {
        return metric == DM.PATH ? directedLength(tables, from, to, lastMove) : distance(tables, from, to, metric);
    }

    static int directedLength(MazeTables tables, int from, int to, int lastMove) {
        requireNode(tables, from);
        requireNode(tables, to);
        return tables.paths().directedLength(from, to, lastMove);
    }

    static @Nullable MOVE nextMove(MazeTables tables, int from, int to, DM metric, boolean towards) {
        return nextMove(tables, from, to, GameState.NO_MOVE, metric, towards);
    }

    /** Compares plain distances from the neighbours, except the one behind. */
    static @Nullable MOVE nextMove(MazeTables tables, int from, int to, int lastMove, DM metric, boolean towards) {
        MazeGraph graph = tables.graph();
        int back = back(graph, from, lastMove);
        MOVE best = null;
        double bestDistance = 0;
        for (int direction = 0; direction < 4; direction++) {
            int next = graph.neighbour(from, direction);
            if (next < 0 || direction == back) {
                continue;
            }
            double distance = distance(tables, next, to, metric);
            if (best == null || (towards ? distance < bestDistance : distance > bestDistance)) {
                best = MOVES[direction];
                bestDistance = distance;
            }
        }
        return best;
    }

    /** Compares distances from the neighbours, except the one behind, along paths that never turn back. */
    static @Nullable MOVE nextMoveDirected(
            MazeTables tables, int from, int to, int lastMove, DM metric, boolean towards, Conventions conventions) {
        MazeGraph graph = tables.graph();
        int back = back(graph, from, lastMove);
        // Quirk of MM-NEAT: "towards" continues from the new move, "away" from the caller's last move.
        boolean followsMove = towards && conventions == Conventions.MM_NEAT;
        MOVE best = null;
        double bestDistance = 0;
        for (int direction = 0; direction < 4; direction++) {
            int next = graph.neighbour(from, direction);
            if (next < 0 || direction == back) {
                continue;
            }
            double distance = distance(tables, next, to, followsMove ? direction : lastMove, metric);
            if (best == null || (towards ? distance < bestDistance : distance > bestDistance)) {
                best = MOVES[direction];
                bestDistance = distance;
            }
        }
        return best;
    }

    private static int back(MazeGraph graph, int node, int lastMove) {
        if (lastMove == GameState.NO_MOVE) {
            return -1;
        }
        int back = MazeGraph.opposite(lastMove);
        if (graph.neighbour(node, back) < 0) {
            throw new NullPointerException("node " + node + " cannot be entered by moving " + MOVES[lastMove]
                    + ": it has no neighbour on the other side");
        }
        return back;
    }

    static int closest(MazeTables tables, int from, int[] targets, DM metric, Conventions conventions) {
        boolean skipsMissing = conventions == Conventions.MM_NEAT;
        int best = -1;
        double bestDistance = Integer.MAX_VALUE;
        for (int target : targets) {
            if (skipsMissing && target == -1) {
                continue;
            }
            double distance = distance(tables, from, target, metric);
            if (distance < bestDistance) {
                bestDistance = distance;
                best = target;
            }
        }
        return best;
    }

    static int farthest(MazeTables tables, int from, int[] targets, DM metric) {
        int best = -1;
        double bestDistance = Integer.MIN_VALUE;
        for (int target : targets) {
            double distance = distance(tables, from, target, metric);
            if (distance > bestDistance) {
                bestDistance = distance;
                best = target;
            }
        }
        return best;
    }
}
