package pacman.maze;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Set;

/**
 * A plain reference implementation of paths, with lists, maps and searches instead of tables. Source:
 * docs/specification/simulator.md, sections 4.3 and 4.4.
 */
final class PlainPaths {

    private static final int NONE = 4;

    private final MazeGraph graph;
    private final MazeDistances distances;
    private final Map<List<Integer>, List<Integer>> junctionPaths = new HashMap<>();

    /** From a node to the next junction: the nodes after the start, first and last move. */
    private record Leg(int start, int junction, int firstMove, int lastMove, List<Integer> path) {
        List<Integer> back() {
            if (path.isEmpty()) {
                return List.of();
            }
            List<Integer> back = new ArrayList<>(path.subList(0, path.size() - 1));
            Collections.reverse(back);
            back.add(start);
            return back;
        }
    }

    /** The state of the search at a node. */
    private static final class Known implements Comparable<Known> {
        private final int node;
        private int travelled;
        private int estimate;
        private Known parent;
        private int arrival;

        Known(int node) {
            this.node = node;
        }

        @Override
        public int compareTo(Known other) {
            return Integer.compare(travelled + estimate, other.travelled + other.estimate);
        }
    }

    PlainPaths(MazeTables tables) {
        graph = tables.graph();
        distances = tables.distances();
    }

    private List<Leg> legs(int node) {
        if (graph.isJunction(node)) {
            return List.of(new Leg(node, node, NONE, NONE, List.of()));
        }
        List<Leg> legs = new ArrayList<>();
        for (int first = 0; first < 4; first++) {
            if (graph.neighbour(node, first) >= 0) {
                List<Integer> path = new ArrayList<>();
                int move = first;
                int here = graph.neighbour(node, first);
                path.add(here);
                while (!graph.isJunction(here)) {
                    int back = move ^ 2;
                    move = 0;
                    while (move == back || graph.neighbour(here, move) < 0) {
                        move++;
                    }
                    here = graph.neighbour(here, move);
                    path.add(here);
                }
                legs.add(new Leg(node, here, first, move, path));
            }
        }
        return legs;
    }

    private List<Integer> junctionPath(int from, int move, int to) {
        return junctionPaths.computeIfAbsent(
                List.of(from, move, to), key -> search(graph.neighbour(from, move), to, move));
    }

    private List<Integer> search(int start, int target, int arrival) {
        Map<Integer, Known> records = new HashMap<>();
        PriorityQueue<Known> open = new PriorityQueue<>();
        Set<Known> closed = new HashSet<>();
        Known first = new Known(start);
        first.estimate = distances.between(start, target);
        first.arrival = arrival;
        records.put(start, first);
        open.add(first);
        while (!open.isEmpty()) {
            Known here = open.poll();
            closed.add(here);
            if (here.node == target) {
                break;
            }
            for (int move = 0; move < 4; move++) {
                int next = graph.neighbour(here.node, move);
                if (next < 0 || here.arrival != NONE && move == (here.arrival ^ 2)) {
                    continue;
                }
                Known record = records.computeIfAbsent(next, Known::new);
                int cost = here.travelled + 1;
                boolean isNew = !open.contains(record) && !closed.contains(record);
                if (isNew || cost < record.travelled) {
                    record.travelled = cost;
                    record.estimate = distances.between(next, target);
                    record.parent = here;
                    record.arrival = move;
                    open.remove(record);
                    closed.remove(record);
                    open.add(record);
                }
            }
        }
        List<Integer> path = new ArrayList<>();
        for (Known record = records.get(target); record != null; record = record.parent) {
            path.add(0, record.node);
        }
        return path;
    }

    private List<Integer> best(int from, int to) {
        List<Integer> best = from == to ? List.of() : null;
        for (int move = 0; move < 4 && from != to; move++) {
            if (graph.neighbour(from, move) >= 0) {
                List<Integer> path = junctionPath(from, move, to);
                if (best == null || path.size() < best.size()) {
                    best = path;
                }
            }
        }
        return best;
    }

    List<Integer> undirected(int from, int to) {
        if (from == to) {
            return List.of();
        }
        for (Leg leg : legs(from)) {
            if (leg.path().contains(to)) {
                return leg.path().subList(0, leg.path().indexOf(to) + 1);
            }
        }
        List<Integer> shortest = null;
        for (Leg out : legs(from)) {
            for (Leg in : legs(to)) {
                List<Integer> path = new ArrayList<>(out.path());
                path.addAll(best(out.junction(), in.junction()));
                path.addAll(in.back());
                if (shortest == null || path.size() < shortest.size()) {
                    shortest = path;
                }
            }
        }
        return shortest;
    }

    List<Integer> directed(int from, int to, int lastMove) {
        if (from == to || from == graph.lair()) {
            return List.of();
        }
        Leg out = null;
        for (Leg leg : legs(from)) {
            boolean isBack = lastMove != NONE && leg.firstMove() == (lastMove ^ 2);
            if (!isBack && (out == null || leg.path().size() < out.path().size())) {
                out = leg;
            }
        }
        if (out.path().contains(to)) {
            return out.path().subList(0, out.path().indexOf(to) + 1);
        }
        List<Integer> path = new ArrayList<>(out.path());
        path.addAll(onwards(out.junction(), graph.isJunction(from) ? lastMove : out.lastMove(), to));
        return path;
    }

    private List<Integer> onwards(int junction, int arrival, int to) {
        List<Integer> result = null;
        for (Leg in : legs(to)) {
            if (in.junction() == junction) {
                int move = 0;
                while (graph.neighbour(junction, move) != in.back().get(0)) {
                    move++;
                }
                if (arrival == NONE || move != (arrival ^ 2)) {
                    result = in.back();
                }
                continue;
            }
            for (int move = 0; move < 4; move++) {
                boolean isOpen = graph.neighbour(junction, move) >= 0 && (arrival == NONE || (move ^ 2) != arrival);
                if (isOpen) {
                    List<Integer> path = new ArrayList<>(junctionPath(junction, move, in.junction()));
                    path.addAll(in.back());
                    if (result == null || path.size() < result.size()) {
                        result = path;
                    }
                }
            }
        }
        return result;
    }
}
