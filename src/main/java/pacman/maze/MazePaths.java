package pacman.maze;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The paths that the simulator gives to controllers and ghosts: corridor, path between two junctions, corridor. They
 * are not always the shortest, because the search for paths between junctions is that of the competition ({@link
 * NonReversingSearch}). Immutable.
 *
 * <p>A path lists the nodes after the start, the target last; its length is its number of steps; it is empty if start
 * and target are the same. Directions are 0 up, 1 right, 2 down, 3 left; a last move may also be 4, none. A
 * <em>directed</em> path never turns back, also not at its start: it does not begin with the opposite of the last move.
 * An <em>undirected</em> path may leave its start in any direction. {@link Routes} explains rows and routes, by which
 * sensors ask for many paths from one place.
 *
 * <p>Source: docs/specification/simulator.md, sections 4.3 and 4.4.
 */
public final class MazePaths {

    /**
     * Number of times that a path can pass one node: once each in its first corridor, its path between junctions, and
     * its last corridor. An array for a path needs this number times the number of nodes.
     */
    public static final int LONGEST = 3;

    private static final int[] EMPTY = {};

    /** In {@link #ends}: more steps than any path has. */
    private static final int NEVER = 0x3FFF;

    /*
     * A path that must not turn back goes along a route (Routes) to the junction at the end of its corridor. What
     * follows depends on the route's row alone. A node in a corridor is then reached from one of the corridor's ends.
     * So two numbers give the lengths to all nodes of a corridor, and only a few corridors need a closer look.
     */
    private final MazeGraph graph;
    private final MazeDistances distances;
    private final Corridors corridors;
    private final Routes routes;
    private final int junctions;
    private final int segments;
    /**
     * Where the path from junction J by move m to junction K starts in {@link #pathNodes}; index (4 J + m) junctions +
     * K.
     */
    private final int[] pathStart;

    private final short[] pathNodes;
    /** Length of the undirected path between junctions J and K, index J junctions + K. */
    private final char[] undirected;
    /**
     * Index segments r + s: length of the path from row r's junction to position 0 of segment s by its lower end, in
     * the upper half; in the lower half the same by its upper end. Where no such numbers give the lengths, the
     * complement of the segment's place in {@link #irregular}.
     */
    private final int[] ends;

    /** Lengths of the paths to one position of a segment after the other. */
    private final int[] irregular;

    MazePaths(MazeGraph graph, MazeDistances distances, Corridors corridors) {
        this.graph = graph;
        this.distances = distances;
        this.corridors = corridors;
        routes = new Routes(graph, corridors);
        junctions = graph.junctionCount();
        segments = routes.segmentCount();
        pathStart = new int[4 * junctions * junctions + 1];
        pathNodes = searchJunctionPaths();
        undirected = new char[junctions * junctions];
        ends = new int[routes.rowCount() * segments];
        List<Integer> lengths = new ArrayList<>();
        for (int row = 0; row < routes.rowCount(); row++) {
            int first = row * segments;
            for (int corridor = 0; corridor < corridors.count(); corridor++) {
                ends[first + corridor] = measure(row, corridor, lengths);
            }
            for (int to = 0; to < junctions; to++) {
                int own = ownJunction(row);
                int length = to == own ? 0 : lengthOn(row, graph.junctionNode(to), choose(row, graph.junctionNode(to)));
                ends[first + corridors.count() + to] = length << 16 | length;
                if (routes.arrivalOfRow(row) == Routes.NEUTRAL) {
                    undirected[own * junctions + to] = (char) length;
                }
            }
        }
        irregular = lengths.stream().mapToInt(Integer::intValue).toArray();
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

    /** Returns the entry of {@link #ends} for a row and a corridor. */
    private int measure(int row, int corridor, List<Integer> irregularLengths) {
        int size = corridors.size(corridor);
        int[] choices = new int[size];
        int[] lengths = new int[size];
        int byLower = NEVER;
        int byUpper = NEVER;
        for (int at = 0; at < size; at++) {
            int node = corridors.node(corridor, at);
            choices[at] = choose(row, node);
            lengths[at] = lengthOn(row, node, choices[at]);
            if (corridors.isAscending(node, choices[at] & 1)) {
                byUpper = lengths[at] + at;
            } else {
                byLower = lengths[at] - at;
            }
        }
        for (int at = 0; at < size; at++) {
            int node = corridors.node(corridor, at);
            boolean isByLower = isByLower(byLower + at, byUpper - at, !corridors.isAscending(node, 0));
            if (isByLower == corridors.isAscending(node, choices[at] & 1)
                    || lengths[at] != (isByLower ? byLower + at : byUpper - at)) {
                int place = irregularLengths.size();
                Arrays.stream(lengths).forEach(irregularLengths::add);
                return ~place;
            }
        }
        return byLower << 16 | byUpper;
    }

    /**
     * Whether a path comes to a node from the lower end of its corridor.
     *
     * @param lowerFirst whether the node's first leg leads there
     */
    static boolean isByLower(int byLower, int byUpper, boolean lowerFirst) {
        return byLower < byUpper || byLower == byUpper && lowerFirst;
    }

    private int ownJunction(int row) {
        return graph.junctionNumber(routes.junctionOfRow(row));
    }

    /** Length of the path from a row's junction to another node, given how it goes on. */
    private int lengthOn(int row, int target, int choice) {
        int leg = corridors.leg(target, choice & 1);
        int move = (choice >> 1) - 1;
        int between = move < 0 ? 0 : junctionPathLength(ownJunction(row), move, Corridors.junctionNumber(leg));
        return between + Corridors.steps(leg);
    }

    /**
     * How the path goes on from a row's junction: the target's leg plus 2 times (1 + the move at the junction), or plus
     * 0 if the target's corridor starts right there.
     */
    private int choose(int row, int target) {
        int junction = ownJunction(row);
        int arrival = routes.arrivalOfRow(row);
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

    private static boolean isBack(int move, int arrival) {
        return arrival != Routes.NEUTRAL && MazeGraph.opposite(arrival) == move;
    }

    public MazeGraph graph() {
        return graph;
    }

    Corridors corridors() {
        return corridors;
    }

    /** The routes that the paths of this maze go along. */
    public Routes routes() {
        return routes;
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

    // ---- Paths that must not turn back ----

    /**
     * Length of the directed path, which must not turn back, from a node that was entered by a last move. It is 0 if
     * both nodes are the same, or if the start is the lair.
     *
     * @param lastMove 0 to 3, or 4 for none
     * @throws IndexOutOfBoundsException if the target is the lair and the start is not
     */
    public int directedLength(int from, int to, int lastMove) {
        if (from == to || from == graph.lair()) {
            return 0;
        }
        requireReachable(to);
        return length(routes.continuing(from, lastMove), 1, to);
    }

    /** The path whose length {@link #directedLength} gives. */
    public int[] directedPath(int from, int to, int lastMove) {
        if (from == to || from == graph.lair()) {
            return EMPTY;
        }
        int[] path = new int[directedLength(from, to, lastMove)];
        path(routes.continuing(from, lastMove), 1, to, path);
        return path;
    }

    /**
     * Length of the path along a route to a target.
     *
     * @param least smallest length that a path within the corridor of the route may have, 0 or 1. It matters only if
     *     the target is the start: with 0 the length is 0; with 1 it is that of the path that leaves along the route
     *     and comes back
     */
    public int length(long route, int least, int target) {
        int ahead = routes.ahead(route, target);
        return ahead >= least ? ahead : Routes.steps(route) + rowLength(Routes.row(route), target);
    }

    /** Length of the path from a row's junction to a target. */
    public int rowLength(int row, int target) {
        return lengthToPlace(row, routes.place(target));
    }

    /** Length of the path from a row's junction to a place, as {@link Routes#place} numbers it. */
    public int lengthToPlace(int row, int place) {
        int both = ends(row, place);
        int at = Routes.position(place);
        return both < 0 ? irregular[~both + at] : Math.min((both >> 16) + at, (both & 0xFFFF) - at);
    }

    /**
     * Returns the lengths of the paths from a row's junction to position 0 of a place's segment: by its lower end in
     * the upper half, by its upper end in the lower half. A number below 0 means that there are no such lengths.
     */
    int ends(int row, int place) {
        return ends[row * segments + Routes.segment(place)];
    }

    /**
     * Writes the path along a route to a target.
     *
     * @param least as in {@link #length}
     * @param path receives the nodes after the start
     * @return the length
     */
    public int path(long route, int least, int target, int[] path) {
        int ahead = routes.ahead(route, target);
        return ahead >= least
                ? follow(route, ahead, path)
                : rowPath(Routes.row(route), target, path, follow(route, Routes.steps(route), path));
    }

    /** Writes the first nodes of a route. */
    private int follow(long route, int count, int[] path) {
        for (int step = 1; step <= count; step++) {
            path[step - 1] = step == Routes.steps(route) ? routes.junction(route) : routes.corridorNode(route, step);
        }
        return count;
    }

    /**
     * Writes the path from a row's junction to a target behind what is already written.
     *
     * @param count nodes already written
     * @return nodes written in all
     */
    public int rowPath(int row, int target, int[] path, int count) {
        if (target == routes.junctionOfRow(row)) {
            return count;
        }
        int choice = choose(row, target);
        int leg = choice & 1;
        int move = (choice >> 1) - 1;
        int next = count;
        if (move >= 0) {
            int end = Corridors.junctionNumber(corridors.leg(target, leg));
            next = writeJunctionPath(ownJunction(row), move, end, path, next);
        }
        return corridors.writeBack(target, leg, path, next);
    }

    // ---- Paths that may leave their start in any direction ----

    /**
     * Length of the path on which the start may be left in any direction.
     *
     * @throws IndexOutOfBoundsException if one node is the lair
     */
    public int undirectedLength(int from, int to) {
        int place = routes.place(from);
        int other = routes.place(to);
        if (Routes.segment(place) == Routes.segment(other)) {
            return Math.abs(place - other);
        }
        requireReachable(from);
        requireReachable(to);
        int first = corridors.leg(from, 0);
        int second = corridors.leg(from, 1);
        if (graph.isJunction(to)) {
            // A junction at the end of the corridor is reached along it, by the first direction that leads there.
            int number = graph.junctionNumber(to);
            if (Corridors.junctionNumber(first) == number) {
                return Corridors.steps(first);
            }
            if (Corridors.junctionNumber(second) == number) {
                return Corridors.steps(second);
            }
        }
        int firstTo = corridors.leg(to, 0);
        int secondTo = corridors.leg(to, 1);
        return Math.min(
                Math.min(lengthByLegs(first, firstTo), lengthByLegs(first, secondTo)),
                Math.min(lengthByLegs(second, firstTo), lengthByLegs(second, secondTo)));
    }

    private int lengthByLegs(int leg, int other) {
        return Corridors.steps(leg)
                + undirected[Corridors.junctionNumber(leg) * junctions + Corridors.junctionNumber(other)]
                + Corridors.steps(other);
    }

    /** The path whose length {@link #undirectedLength} gives. */
    public int[] undirectedPath(int from, int to) {
        int[] path = new int[undirectedLength(from, to)];
        if (path.length == 0) {
            return EMPTY;
        }
        for (int out = 0; out < corridors.legCount(from); out++) {
            long route = routeOf(from, out);
            if (routes.ahead(route, to) > 0 || routes.junction(route) == to) {
                follow(route, path.length, path);
                return path;
            }
        }
        for (int out = 0; out < corridors.legCount(from); out++) {
            for (int in = 0; in < corridors.legCount(to); in++) {
                if (lengthByLegs(corridors.leg(from, out), corridors.leg(to, in)) == path.length) {
                    writeUndirected(from, out, to, in, path);
                    return path;
                }
            }
        }
        throw new IllegalStateException("no path from node " + from + " to node " + to + " of maze " + graph.name());
    }

    private void writeUndirected(int from, int out, int to, int in, int[] path) {
        int first = Corridors.junctionNumber(corridors.leg(from, out));
        int last = Corridors.junctionNumber(corridors.leg(to, in));
        int next = follow(routeOf(from, out), corridors.length(from, out), path);
        if (first != last) {
            int move = 0;
            while (junctionPathLength(first, move, last) != undirected[first * junctions + last]) {
                move++;
            }
            next = writeJunctionPath(first, move, last, path, next);
        }
        corridors.writeBack(to, in, path, next);
    }

    private long routeOf(int node, int leg) {
        int move = corridors.firstMove(node, leg);
        return move == Corridors.NO_MOVE ? routes.continuing(node, Routes.NEUTRAL) : routes.leaving(node, move);
    }

    /**
     * Writes the nodes of the stored path between two junctions, from the neighbour by the move.
     *
     * @return the index after the last node written
     */
    int writeJunctionPath(int from, int move, int to, int[] out, int start) {
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
