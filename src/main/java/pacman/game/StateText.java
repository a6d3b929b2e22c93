package pacman.game;

import static pacman.game.GameState.EDIBLE;
import static pacman.game.GameState.GHOSTS;
import static pacman.game.GameState.LAIR;
import static pacman.game.GameState.POSE;

import java.util.Arrays;
import java.util.Objects;
import mmneat.random.ResumableRandom;
import pacman.game.Constants.MOVE;
import pacman.game.GameRules.Conventions;
import pacman.maze.MazePoses;

/**
 * Writes and reads state strings: fields separated by commas. The competition's has {@value #SHORT} fields. MM-NEAT's
 * has {@value #LONG}, with generator, counters and switches first. Both can be read under any conventions.
 *
 * <p>Source: docs/specification/simulator.md, section 5.
 */
final class StateText {

    private static final int SHORT = 35;
    private static final int LONG = 56;
    private static final int LONGEST_SHOWN = 80;
    private static final MOVE[] MOVES = MOVE.values();

    /** Next field to read. */
    private final String[] fields;

    private int next;

    private StateText(String[] fields) {
        this.fields = fields;
    }

    static String write(GameState state) {
        boolean isLong = state.rules.conventions() == Conventions.MM_NEAT;
        StringBuilder text = new StringBuilder(700);
        if (isLong) {
            writeCounters(state, text);
        }
        append(text, state.mazeIndex, state.totalTime, state.score, state.levelTime, state.level);
        if (isLong) {
            append(text, state.timesLevel);
        }
        append(text, state.pacManNode(), MOVES[MazePoses.move(state.pacManPose)], state.lives, state.extraLifeReceived);
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            append(
                    text,
                    state.ghostNode(ghost),
                    state.ghosts[EDIBLE + ghost],
                    state.ghosts[LAIR + ghost],
                    MOVES[state.ghostMove(ghost)]);
        }
        for (int pill = 0; pill < state.graph.pillCount(); pill++) {
            text.append(state.hasPill(pill) ? '1' : '0');
        }
        text.append(',');
        for (int powerPill = 0; powerPill < state.graph.powerPillCount(); powerPill++) {
            text.append(state.powerPills >>> powerPill & 1);
        }
        text.append(',');
        append(text, state.timeOfLastReversal, state.pacManEaten);
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            append(text, (state.ghostsEaten >>> ghost & 1) != 0);
        }
        append(text, state.pillEaten, state.powerPillEaten);
        text.setLength(text.length() - 1);
        return text.toString();
    }

    private static void writeCounters(GameState state, StringBuilder text) {
        append(text, state.random.bits());
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            append(text, state.ghosts[GameState.EATEN + ghost]);
        }
        append(
                text,
                state.lureDistance,
                state.timeInDeadSpace,
                state.powerPillsEatenWhenGhostFar,
                state.improperlyEatenPowerPills,
                state.properlyEatenPowerPills,
                state.timePillReward,
                state.timeGhostReward,
                state.ghostReward,
                state.ghostRegret,
                state.eatenGhosts,
                state.eatenPills,
                state.has(GameSwitch.WITHOUT_PILLS),
                state.has(GameSwitch.WITHOUT_POWER_PILLS),
                state.has(GameSwitch.END_AFTER_GHOST_EATING_CHANCES),
                state.has(GameSwitch.END_AFTER_POWER_PILLS_EATEN));
    }

    private static void append(StringBuilder text, Object... values) {
        for (Object value : values) {
            text.append(value).append(',');
        }
    }

    /** Restores the fields of the string; everything else stays unchanged. */
    static void read(GameState state, String text) {
        String[] fields = text.trim().split(",", -1);
        if (fields.length != SHORT && fields.length != LONG) {
            throw new IllegalArgumentException("a game state has " + LONG + " fields, or " + SHORT
                    + " in the competition's form, this one has " + fields.length + ": " + shortened(text));
        }
        try {
            // Read into another game first, so that this game stays unchanged if the string is invalid.
            new StateText(fields).read(new GameState(0, state.rules, null));
            new StateText(fields).read(state);
        } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
            throw new IllegalArgumentException(
                    "not a state of a game in these mazes (" + e.getMessage() + "): " + shortened(text), e);
        }
    }

    private static String shortened(String text) {
        return text.length() <= LONGEST_SHOWN ? text : text.substring(0, LONGEST_SHOWN) + "...";
    }

    private void read(GameState state) {
        boolean isLong = fields.length == LONG;
        if (isLong) {
            readCounters(state);
        }
        state.mazeIndex = nextInt();
        state.enterMaze();
        state.totalTime = nextInt();
        state.score = nextInt();
        state.levelTime = nextInt();
        state.level = nextInt();
        state.timesLevel = isLong ? nextInt() : state.level;
        state.pacManPose = MazePoses.of(nextNode(state), nextMove());
        state.lives = nextInt();
        state.extraLifeReceived = nextBoolean();
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            int node = nextNode(state);
            state.ghosts[EDIBLE + ghost] = nextInt();
            state.ghosts[LAIR + ghost] = nextInt();
            state.ghosts[POSE + ghost] = MazePoses.of(node, nextMove());
        }
        state.minGhostDistance = 0;
        readPills(state, fields[next++], fields[next++]);
        state.timeOfLastReversal = nextInt();
        state.pacManEaten = nextBoolean();
        state.ghostsEaten = 0;
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            state.ghostsEaten |= nextBoolean() ? 1 << ghost : 0;
        }
        state.pillEaten = nextBoolean();
        state.powerPillEaten = nextBoolean();
    }

    private void readCounters(GameState state) {
        state.random.setState(new ResumableRandom.State(Long.parseLong(fields[next++]), false, 0));
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            state.ghosts[GameState.EATEN + ghost] = nextInt();
        }
        state.lureDistance = Double.parseDouble(fields[next++]);
        state.timeInDeadSpace = Long.parseLong(fields[next++]);
        state.powerPillsEatenWhenGhostFar = nextInt();
        state.improperlyEatenPowerPills = nextInt();
        state.properlyEatenPowerPills = nextInt();
        state.timePillReward = nextInt();
        state.timeGhostReward = nextInt();
        state.ghostReward = nextInt();
        state.ghostRegret = nextInt();
        state.eatenGhosts = nextInt();
        state.eatenPills = nextInt();
        state.set(GameSwitch.WITHOUT_PILLS, nextBoolean());
        state.set(GameSwitch.WITHOUT_POWER_PILLS, nextBoolean());
        state.set(GameSwitch.END_AFTER_GHOST_EATING_CHANCES, nextBoolean());
        state.set(GameSwitch.END_AFTER_POWER_PILLS_EATEN, nextBoolean());
    }

    private static void readPills(GameState state, String pills, String powerPills) {
        // As in the original, all pills are set first, which draws random numbers under preEatenPillPortion.
        LevelPills.fill(state);
        LevelPills.fillPowerPills(state);
        requireLength("pills", pills, state.graph.pillCount());
        requireLength("power pills", powerPills, state.graph.powerPillCount());
        Arrays.fill(state.pills, 0);
        state.pillsLeft = 0;
        for (int pill = 0; pill < pills.length(); pill++) {
            if (pills.charAt(pill) == '1') {
                state.pills[pill >> 6] |= 1L << pill;
                state.pillsLeft++;
            }
        }
        state.powerPills = 0;
        for (int powerPill = 0; powerPill < powerPills.length(); powerPill++) {
            if (powerPills.charAt(powerPill) == '1') {
                state.powerPills |= 1L << powerPill;
            }
        }
    }

    private static void requireLength(String what, String bits, int count) {
        if (bits.length() != count) {
            throw new IllegalArgumentException(
                    "the maze has " + count + " " + what + ", the state string " + bits.length());
        }
    }

    /**
     * Reads a node. After the last level, nodes are still those of its maze; a game with more levels continues in the
     * next maze.
     */
    private int nextNode(GameState state) {
        int lastNodes =
                state.rules.mazes().mazes().get(state.shownMazeIndex()).graph().nodeCount();
        return Objects.checkIndex(nextInt(), Math.max(state.graph.nodeCount(), lastNodes));
    }

    private int nextInt() {
        return Integer.parseInt(fields[next++]);
    }

    private boolean nextBoolean() {
        return Boolean.parseBoolean(fields[next++]);
    }

    private int nextMove() {
        return MOVE.valueOf(fields[next++]).ordinal();
    }
}
