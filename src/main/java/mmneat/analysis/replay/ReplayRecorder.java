package mmneat.analysis.replay;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Recorder of games, step by step, in a packed form.
 *
 * <p>Every quantity is a {@link Column}: one, two or three bytes per step. A column holds differences from step to
 * step, because nearly all differences are 0 or repeat, and deflate compresses repeated bytes well. Sensor values are
 * rounded to 1/127, activations to 1/32: finer than the eye can tell. A game of four mazes, 8,000 steps with 30 sensors
 * and 40 nodes for each direction, is 2.3 million values and packs to well under a megabyte.
 */
public final class ReplayRecorder {

    private static final int WALL = 255;
    private static final int SENSOR_SCALE = 127;
    private static final int ACTIVATION_SCALE = 32;

    private final ReplayNetwork network;
    private final Map<Integer, ReplayMaze> mazes = new LinkedHashMap<>();
    private final List<Chapter> chapters = new ArrayList<>();
    private final List<Outcome> outcomes = new ArrayList<>();
    private final Map<String, Column> columns = new LinkedHashMap<>();
    /** The values of each direction's network, [direction][input] and [direction][node]. */
    private final Column[][] sensorColumns = new Column[4][];

    private final Column[][] nodeColumns = new Column[4][];
    private final BitSet pillsBefore = new BitSet();
    private final BitSet powerPillsBefore = new BitSet();
    private final int detailEvery;
    private String game = "";
    private boolean newGame = true;
    private int levelBefore;
    private int steps;
    /** Sum of the final scores of the games before the current one. */
    private int earlierScore;

    private int lastScore;

    /**
     * A part of the recording that starts with new pills.
     *
     * @param step first step
     * @param game name of the game, empty if there is only one
     * @param level level of the game, from 0
     * @param maze index of the maze
     * @param pills numbers of the pills at its start
     * @param powerPills numbers of the power pills at its start
     */
    record Chapter(int step, String game, int level, int maze, int[] pills, int[] powerPills) {}

    /** The outcome of a game, shown at its last step. */
    record Outcome(int step, String text) {}

    /**
     * A recorder for a player with the given network.
     *
     * @param detailEvery interval in steps at which sensor values and activations are kept, at least 1
     */
    public ReplayRecorder(ReplayNetwork network, int detailEvery) {
        if (detailEvery < 1) {
            throw new IllegalArgumentException("steps between two details must be at least 1, are " + detailEvery);
        }
        this.network = network;
        this.detailEvery = detailEvery;
        for (int direction = 0; direction < 4; direction++) {
            sensorColumns[direction] =
                    detailColumns("sensor" + direction, network.inputs().size());
            nodeColumns[direction] =
                    detailColumns("node" + direction, network.nodes().size());
        }
    }

    private static Column[] detailColumns(String kind, int count) {
        Column[] columns = new Column[count];
        Arrays.setAll(columns, i -> new Column(kind + "_" + i, 1));
        return columns;
    }

    /** Adds a maze; required once before the first step in it. */
    public void addMaze(ReplayMaze maze) {
        mazes.put(maze.index(), maze);
    }

    /** Whether the maze of this index was added. */
    public boolean knowsMaze(int index) {
        return mazes.containsKey(index);
    }

    /** Starts a game: the following steps belong to it. An isolated trial, for example, has five games. */
    public void startGame(String name) {
        game = name;
        newGame = true;
        earlierScore += lastScore;
        lastScore = 0;
    }

    /** Sets the outcome of the game whose last state was just recorded, for example "caught by Blinky". */
    public void endGame(String outcome) {
        outcomes.add(new Outcome(steps - 1, outcome));
    }

    /** Appends one step; {@code step} may be changed afterwards. */
    public void record(ReplayStep step) {
        if (!mazes.containsKey(step.maze)) {
            throw new IllegalStateException("the maze " + step.maze + " was not added before a step in it");
        }
        int eaten = eaten(step.pills, pillsBefore) + 2 * eaten(step.powerPills, powerPillsBefore);
        if (newGame || step.level != levelBefore) {
            chapters.add(
                    new Chapter(steps, game, step.level, step.maze, numbers(step.pills), numbers(step.powerPills)));
            eaten = 0;
        }
        newGame = false;
        levelBefore = step.level;
        remember(step.pills, pillsBefore);
        remember(step.powerPills, powerPillsBefore);
        column("eaten", 1).add(eaten);
        column("score", 3).add(step.score);
        column("lives", 1).add(step.lives);
        column("levelTime", 2).add(step.levelTime);
        column("node", 2).add(step.pacMan);
        column("move", 1).add(step.pacManMove);
        for (int ghost = 0; ghost < 4; ghost++) {
            column("ghostNode" + ghost, 2).add(step.ghosts[ghost]);
            column("ghostMove" + ghost, 1).add(step.ghostMoves[ghost]);
            column("edible" + ghost, 2).add(step.edibleTimes[ghost]);
            column("lair" + ghost, 2).add(step.lairTimes[ghost]);
        }
        column("module", 1).add(step.module < 0 ? WALL : step.module);
        column("choice", 1).add(step.choice);
        for (int direction = 0; direction < 4; direction++) {
            boolean open = step.open[direction];
            column("preference" + direction, 1).add(open ? quantise(step.preferences[direction], SENSOR_SCALE) : WALL);
            column("moduleOf" + direction, 1).add(open ? step.modules[direction] : WALL);
        }
        if (steps % detailEvery == 0) {
            recordDetails(step);
        }
        lastScore = step.score;
        steps++;
    }

    private void recordDetails(ReplayStep step) {
        for (int direction = 0; direction < 4; direction++) {
            boolean open = step.open[direction];
            recordDetails(sensorColumns[direction], open, step.sensors[direction], SENSOR_SCALE);
            recordDetails(nodeColumns[direction], open, step.activations[direction], ACTIVATION_SCALE);
        }
    }

    private static void recordDetails(Column[] columns, boolean open, double[] values, int scale) {
        for (int i = 0; i < values.length; i++) {
            if (open) {
                columns[i].add(quantise(values[i], scale));
            } else {
                // A direction with a wall has no values. A repeated value compresses to almost nothing.
                columns[i].repeat();
            }
        }
    }

    /**
     * The complete recording.
     *
     * @throws IllegalStateException if no step was recorded
     */
    public Replay finish(ReplayTitle title) {
        if (steps == 0) {
            throw new IllegalStateException("nothing was recorded");
        }
        return new Replay(
                title,
                steps,
                earlierScore + lastScore,
                detailEvery,
                SENSOR_SCALE,
                ACTIVATION_SCALE,
                List.copyOf(mazes.values()),
                List.copyOf(chapters),
                List.copyOf(outcomes),
                network,
                allColumns());
    }

    private List<Column> allColumns() {
        List<Column> all = new ArrayList<>(columns.values());
        for (int direction = 0; direction < 4; direction++) {
            all.addAll(Arrays.asList(sensorColumns[direction]));
            all.addAll(Arrays.asList(nodeColumns[direction]));
        }
        return all;
    }

    private Column column(String name, int width) {
        return columns.computeIfAbsent(name, key -> new Column(key, width));
    }

    /** Maps [-1, 1] linearly to the integers from 0 to 2 x scale; values outside are clamped. */
    private static int quantise(double value, int scale) {
        return (int) Math.round((Math.max(-1, Math.min(1, value)) + 1) * scale);
    }

    private static int eaten(boolean[] now, BitSet before) {
        for (int i = before.nextSetBit(0); i >= 0; i = before.nextSetBit(i + 1)) {
            if (i >= now.length || !now[i]) {
                return 1;
            }
        }
        return 0;
    }

    private static void remember(boolean[] present, BitSet into) {
        into.clear();
        for (int i = 0; i < present.length; i++) {
            into.set(i, present[i]);
        }
    }

    private static int[] numbers(boolean[] present) {
        return java.util.stream.IntStream.range(0, present.length)
                .filter(i -> present[i])
                .toArray();
    }
}
