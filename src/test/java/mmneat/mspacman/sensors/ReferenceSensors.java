package mmneat.mspacman.sensors;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import pacman.maze.MazeDistances;
import pacman.maze.MazeGraph;
import pacman.maze.MazePaths;
import pacman.maze.MazeTables;

/**
 * A plain reference implementation of the sensors, which searches, lists and compares whole paths. It is slow and uses
 * none of the tables of the fast form. Source: docs/specification/mspacman-task.md, section 4.
 */
public final class ReferenceSensors {

    private final RandomState state;
    private final MazeGraph graph;
    private final MazePaths paths;
    private final MazeDistances distances;

    public ReferenceSensors(MazeTables maze, RandomState state) {
        this.state = state;
        graph = maze.graph();
        paths = maze.paths();
        distances = maze.distances();
    }

    /** All inputs in a direction; published sensors that can be left out are there. */
    public double[] inputs(int d, SensorSettings settings) {
        List<Double> inputs = new ArrayList<>();
        inputs.add(1.0);
        inputs.add(scaled(nearestLength(state.activePillNodes(graph), d)));
        inputs.add(scaled(nearestLength(state.activePowerPillNodes(graph), d)));
        junctions().stream()
                .map(junction -> pathLength(state.pacMan, junction, d))
                .sorted()
                .limit(settings.junctionsToSense())
                .forEach(length -> inputs.add(scaled(length)));
        for (int ghost = 0; ghost < 4 && settings.has(SensorGroup.NUMBERED_GHOSTS); ghost++) {
            boolean isOutside = state.lair[ghost] == 0;
            inputs.add(isOutside ? ghostDistance(ghost, d) : 1.0);
            inputs.add(flag(isOutside && isApproaching(ghost, d)));
        }
        if (settings.has(SensorGroup.NEAREST_GHOSTS)) {
            List<Integer> order = ghostsByDistance(d, ghost -> true);
            for (int n = 0; n < 4; n++) {
                addNthGhost(nth(n, order), d, settings, inputs);
            }
        }
        if (settings.has(SensorGroup.NEAREST_OF_EACH_KIND)) {
            List<Integer> threats = ghostsByDistance(d, ghost -> state.edible[ghost] == 0);
            List<Integer> edible = ghostsByDistance(d, ghost -> state.edible[ghost] > 0);
            for (int n = 0; n < 4; n++) {
                addNthOfEachKind(nth(n, threats), nth(n, edible), d, inputs);
            }
        }
        int depth = settings.smallStepSimDepth();
        inputs.add(mostOnWalks(d, depth, node -> state.isPillActive(graph.pillNumber(node))) / 8.0);
        inputs.add(mostOnWalks(d, depth, graph::isJunction) / 5.0);
        int powerPills = state.activePowerPillNodes(graph).size();
        inputs.add(powerPills == 0 ? 0.0 : (double) powerPills / graph.powerPillCount());
        inputs.add((double) state.activePillNodes(graph).size() / graph.pillCount());
        inputs.add(IntStream.of(state.edible).filter(time -> time > 0).count() / 4.0);
        inputs.add(IntStream.of(state.edible).max().orElseThrow() / 200.0);
        inputs.add(IntStream.of(state.edible).anyMatch(time -> time > 0) ? 1.0 : 0.0);
        inputs.add(IntStream.range(0, 4).allMatch(this::isThreat) ? 1.0 : 0.0);
        inputs.add(
                state.activePowerPillNodes(graph).stream().anyMatch(node -> distances.between(state.pacMan, node) < 10)
                        ? 1.0
                        : 0.0);
        inputs.add(options(d) / 4.0);
        return inputs.stream().mapToDouble(Double::doubleValue).toArray();
    }

    /** @param ghost -1 if there are not so many outside the lair */
    private void addNthGhost(int ghost, int d, SensorSettings settings, List<Double> inputs) {
        boolean exists = ghost >= 0;
        inputs.add(exists ? ghostDistance(ghost, d) : 1.0);
        inputs.add(flag(exists && isApproaching(ghost, d)));
        inputs.add(flag(exists && isTrapped(ghost, d)));
        if (settings.has(SensorGroup.TIME_VERSUS_DISTANCE)) {
            int spare = exists ? state.edible[ghost] - path(state.pacMan, state.ghostNode[ghost], d).length : 0;
            inputs.add(exists ? Math.max(-1.0, Math.min(1.0, spare / 200.0)) : -1.0);
        }
        if (settings.has(SensorGroup.EDIBLE)) {
            inputs.add(flag(exists && state.edible[ghost] > 0));
        }
    }

    private void addNthOfEachKind(int threat, int edible, int d, List<Double> inputs) {
        inputs.add(threat >= 0 ? ghostDistance(threat, d) : 1.0);
        inputs.add(edible >= 0 ? ghostDistance(edible, d) : 1.0);
        inputs.add(flag(threat >= 0 && isApproaching(threat, d)));
        inputs.add(flag(edible >= 0 && isApproaching(edible, d)));
        inputs.add(flag(threat >= 0 && isTrapped(threat, d)));
        inputs.add(flag(edible >= 0 && isTrapped(edible, d)));
    }

    private static int nth(int n, List<Integer> ghosts) {
        return n < ghosts.size() ? ghosts.get(n) : -1;
    }

    private double ghostDistance(int ghost, int d) {
        return scaled(path(state.pacMan, state.ghostNode[ghost], d).length);
    }

    private static double flag(boolean holds) {
        return holds ? 1.0 : 0.0;
    }

    private static double scaled(int steps) {
        return steps < 0 ? 1 : Math.min(steps, 200) / 200.0;
    }

    private boolean isThreat(int ghost) {
        return state.edible[ghost] == 0 && state.ghostNode[ghost] != graph.lair();
    }

    private List<Integer> junctions() {
        return IntStream.range(0, graph.junctionCount())
                .map(graph::junctionNode)
                .boxed()
                .toList();
    }

    /** The directional path dpath. */
    private int[] path(int from, int to, int d) {
        if (isStraight(from, d)) {
            return paths.directedPath(from, to, d);
        }
        int next = graph.neighbour(from, d);
        int[] rest = paths.directedPath(next, to, d);
        int[] path = new int[rest.length + 1];
        path[0] = next;
        System.arraycopy(rest, 0, path, 1, rest.length);
        return path;
    }

    private boolean isStraight(int from, int d) {
        return graph.neighbour(from, (d + 1) % 4) < 0 && graph.neighbour(from, (d + 3) % 4) < 0;
    }

    private int pathLength(int from, int to, int d) {
        return isStraight(from, d)
                ? paths.directedLength(from, to, d)
                : 1 + paths.directedLength(graph.neighbour(from, d), to, d);
    }

    private int[] ghostPath(int ghost, int to) {
        return paths.directedPath(state.ghostNode[ghost], to, state.lastMove[ghost]);
    }

    private int nearest(int from, List<Integer> targets, int d) {
        int nearest = -1;
        int shortest = Integer.MAX_VALUE;
        for (int target : targets) {
            int length = pathLength(from, target, d);
            if (length < shortest) {
                nearest = target;
                shortest = length;
            }
        }
        return nearest;
    }

    private int nearestLength(List<Integer> targets, int d) {
        return targets.isEmpty() ? -1 : pathLength(state.pacMan, nearest(state.pacMan, targets, d), d);
    }

    private List<Integer> ghostsByDistance(int d, IntPredicate counts) {
        List<Integer> ghosts = new ArrayList<>();
        for (int ghost = 0; ghost < 4; ghost++) {
            if (state.lair[ghost] == 0 && counts.test(ghost)) {
                ghosts.add(ghost);
            }
        }
        ghosts.sort(Comparator.comparingInt(ghost -> {
            int length = path(state.pacMan, state.ghostNode[ghost], d).length;
            return length == 0 ? Integer.MAX_VALUE : length;
        }));
        return ghosts;
    }

    private boolean isApproaching(int ghost, int d) {
        return contains(ghostPath(ghost, state.pacMan), graph.neighbour(state.pacMan, d));
    }

    private boolean isTrapped(int ghost, int d) {
        return IntStream.of(path(state.pacMan, state.ghostNode[ghost], d)).noneMatch(graph::isJunction);
    }

    private static boolean contains(int[] path, int node) {
        for (int onPath : path) {
            if (onPath == node) {
                return true;
            }
        }
        return false;
    }

    private static boolean containsAll(int[] path, int[] nodes) {
        for (int node : nodes) {
            if (!contains(path, node)) {
                return false;
            }
        }
        return true;
    }

    private int mostOnWalks(int d, int depth, IntPredicate counts) {
        boolean[] seen = new boolean[graph.nodeCount()];
        seen[state.pacMan] = true;
        return mostOnWalks(graph.neighbour(state.pacMan, d), d, depth, counts, seen);
    }

    private int mostOnWalks(int node, int move, int steps, IntPredicate counts, boolean[] seen) {
        if (steps == 0) {
            return 0;
        }
        int own = !seen[node] && counts.test(node) ? 1 : 0;
        boolean before = seen[node];
        seen[node] = true;
        int most = 0;
        for (int m = 0; m < 4; m++) {
            if (m != (move + 2) % 4 && graph.neighbour(node, m) >= 0) {
                most = Math.max(most, mostOnWalks(graph.neighbour(node, m), m, steps - 1, counts, seen));
            }
        }
        seen[node] = before;
        return own + most;
    }

    private int options(int d) {
        int next = nearest(state.pacMan, junctions(), d);
        if (!isSafe(next, d)) {
            return 0;
        }
        int count = 0;
        for (int m = 0; m < 4; m++) {
            if (graph.neighbour(next, m) >= 0) {
                int beyond = nearest(next, junctions(), m);
                if (beyond != state.pacMan && !contains(path(next, beyond, m), state.pacMan) && isSafe(beyond, d)) {
                    count++;
                }
            }
        }
        return count;
    }

    private boolean isSafe(int proposedTarget, int d) {
        int target = proposedTarget;
        int[] own = path(state.pacMan, target, d);
        List<Integer> pills = state.activePillNodes(graph);
        int[] ownAtFirst = own;
        if (!pills.isEmpty()
                && state.activePowerPillNodes(graph).isEmpty()
                && pills.stream().allMatch(pill -> contains(ownAtFirst, pill))) {
            for (int pill : pills) {
                int[] toPill = path(state.pacMan, pill, d);
                if (pill == pills.get(0) || toPill.length > own.length) {
                    target = pill;
                    own = toPill;
                }
            }
        }
        for (int ghost = 0; ghost < 4; ghost++) {
            if (stops(ghost, target, own, d)) {
                return false;
            }
        }
        return true;
    }

    private boolean stops(int ghost, int target, int[] own, int d) {
        int node = state.ghostNode[ghost];
        if (state.lair[ghost] > 0) {
            return state.lair[ghost] < own.length
                    && distances.between(graph.ghostStart(), target) + state.lair[ghost] - 2 <= own.length;
        }
        int[] ghostPath = ghostPath(ghost, target);
        boolean isOnPath = contains(own, node);
        boolean runsAhead = !graph.isJunction(node) && isOnPath && containsAll(own, ghostPath);
        boolean heads = isOnPath
                && paths.directedPath(node, state.pacMan, state.lastMove[ghost]).length
                        == paths.undirectedPath(node, state.pacMan).length;
        if (state.edible[ghost] == 0) {
            boolean ignored = node == target && !isApproaching(ghost, d) || runsAhead;
            return !ignored && (heads || ghostPath.length - 2 <= own.length);
        }
        int time = state.edible[ghost];
        if (runsAhead) {
            return false;
        }
        if (heads && 2 * ((distances.between(node, state.pacMan) - 2) / 3) >= time) {
            return true;
        }
        return own.length >= time && ghostPath.length + time - 2 <= own.length;
    }
}
