package mmneat.analysis.replay;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import mmneat.analysis.replay.ReplayNetwork.Kind;
import mmneat.analysis.replay.ReplayNetwork.Link;
import mmneat.analysis.replay.ReplayNetwork.Node;

/**
 * A constructed game: Ms. Pac-Man runs around a square in two levels, one module per level, eating ten points a pill.
 */
final class SyntheticReplay {

    static final int STEPS_PER_LEVEL = 160;

    private static final int SIDE = 40;

    private SyntheticReplay() {}

    static Replay record() {
        ReplayNetwork network = network(List.of("Bias", "Distance"));
        ReplayRecorder recorder = new ReplayRecorder(network, 1);
        recorder.addMaze(maze());
        record(recorder, new ReplayStep(network), 10);
        return recorder.finish(new ReplayTitle("A <square> & its \"runner\"", "made for a test </script>"));
    }

    /** Games with long names and scores of five digits, played by a network with this number of sensors. */
    static Replay isolatedGames(int inputs) {
        ReplayNetwork network = network(IntStream.rangeClosed(1, inputs)
                .mapToObj(i -> "Ghost " + i + " approaching")
                .toList());
        ReplayRecorder recorder = new ReplayRecorder(network, 1);
        recorder.addMaze(maze());
        for (String game : new String[] {"Pills", "Ghosts 3", "Ghosts 4"}) {
            recorder.startGame(game);
            record(recorder, new ReplayStep(network), 170);
        }
        return recorder.finish(new ReplayTitle("isolated · a network", "training rules, seed 0, network 26773"));
    }

    private static ReplayNetwork network(List<String> inputs) {
        int first = inputs.size();
        return new ReplayNetwork(
                inputs,
                List.of(
                        new Node(Kind.HIDDEN, -1, 0.5),
                        new Node(Kind.POLICY, 0, 1),
                        new Node(Kind.PREFERENCE, 0, 1),
                        new Node(Kind.POLICY, 1, 1),
                        new Node(Kind.PREFERENCE, 1, 1)),
                List.of(
                        new Link(0, first, 1.5, false),
                        new Link(1, first, -2, false),
                        new Link(first, first + 1, 1, false),
                        new Link(first, first + 3, -1, false),
                        new Link(first, first, 0.5, true)),
                List.of("module 1", "module 2"));
    }

    /** A game of two levels. */
    private static void record(ReplayRecorder recorder, ReplayStep step, int pointsPerPill) {
        int score = 0;
        for (int level = 0; level < 2; level++) {
            step.level = level;
            step.lives = 1;
            step.pills = new boolean[SIDE];
            Arrays.fill(step.pills, true);
            for (int t = 0; t < STEPS_PER_LEVEL; t++) {
                if (t % 4 == 1) {
                    step.pills[t / 4] = false;
                    score += pointsPerPill;
                }
                boolean end = level == 1 && t == STEPS_PER_LEVEL - 1;
                if (end) {
                    score += 200;
                }
                fill(step, t, score, end ? -1 : level);
                recorder.record(step);
            }
        }
        recorder.endGame("All mazes cleared");
    }

    private static void fill(ReplayStep step, int t, int score, int module) {
        int heading = t / SIDE;
        step.levelTime = t;
        step.score = score;
        step.pacMan = t;
        step.pacManMove = (heading + 1) % 4;
        step.module = module;
        step.choice = module < 0 ? ReplayStep.NO_MOVE : (heading + 1) % 4;
        Arrays.fill(step.ghosts, (t + 60) % STEPS_PER_LEVEL);
        Arrays.fill(step.edibleTimes, Math.max(0, 100 - t));
        for (int direction = 0; direction < 4; direction++) {
            step.open[direction] = direction % 2 == step.pacManMove % 2;
            step.preferences[direction] = direction == step.choice ? 0.75 : -0.5;
            step.modules[direction] = Math.max(0, module);
            step.sensors[direction][0] = 1;
            step.sensors[direction][1] = t / 160.0;
            Arrays.fill(step.activations[direction], Math.sin(t / 10.0));
        }
    }

    /** A square of one corridor, clockwise from the upper left corner. */
    private static ReplayMaze maze() {
        int nodes = 4 * SIDE;
        int[] x = new int[nodes];
        int[] y = new int[nodes];
        int[] right = new int[nodes];
        int[] down = new int[nodes];
        Arrays.fill(right, -1);
        Arrays.fill(down, -1);
        for (int i = 0; i < SIDE; i++) {
            put(x, y, i, 10 + 2 * i, 10);
            put(x, y, SIDE + i, 10 + 2 * SIDE, 10 + 2 * i);
            put(x, y, 2 * SIDE + i, 10 + 2 * SIDE - 2 * i, 10 + 2 * SIDE);
            put(x, y, 3 * SIDE + i, 10, 10 + 2 * SIDE - 2 * i);
            right[i] = i + 1;
            down[SIDE + i] = SIDE + i + 1;
            right[(2 * SIDE + i + 1) % nodes] = 2 * SIDE + i;
            down[(3 * SIDE + i + 1) % nodes] = 3 * SIDE + i;
        }
        int[] pills = new int[SIDE];
        for (int i = 0; i < SIDE; i++) {
            pills[i] = 4 * i + 1;
        }
        return new ReplayMaze(0, x, y, right, down, pills, new int[0], -1);
    }

    private static void put(int[] x, int[] y, int node, int nodeX, int nodeY) {
        x[node] = nodeX;
        y[node] = nodeY;
    }
}
