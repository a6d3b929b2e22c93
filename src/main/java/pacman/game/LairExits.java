package pacman.game;

import static pacman.game.GameState.EDIBLE;
import static pacman.game.GameState.GHOSTS;
import static pacman.game.GameState.LAIR;
import static pacman.game.GameState.POSE;

import java.util.Objects;
import pacman.maze.MazePoses;

/**
 * The part of a game step in which lair times decrease and ghosts leave the lair.
 *
 * <p>Source: docs/specification/simulator.md, sections 2.6 and 7.
 */
final class LairExits {

    private LairExits() {}

    /** Step 9: lair times decrease, and ghosts leave the lair. */
    static void update(GameState state) {
        if (!state.isAnyInLair()) {
            return;
        }
        if (state.levelTime == 0 || isAnyLairTimeOver(state)) {
            leaveLair(state);
            return;
        }
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            if (state.ghosts[LAIR + ghost] > 0 && ghost < state.rules.ghosts().activeGhosts()) {
                state.ghosts[LAIR + ghost]--;
            }
        }
    }

    private static boolean isAnyLairTimeOver(GameState state) {
        int[] ghosts = state.ghosts;
        return ghosts[LAIR] == 1 || ghosts[LAIR + 1] == 1 || ghosts[LAIR + 2] == 1 || ghosts[LAIR + 3] == 1;
    }

    /** The part of a step in which ghosts leave the lair. */
    private static void leaveLair(GameState state) {
        int[] ghosts = state.ghosts;
        boolean exit = false;
        for (int ghost = 0; ghost < state.rules.ghosts().activeGhosts(); ghost++) {
            if (ghosts[LAIR + ghost] <= 0) {
                continue;
            }
            ghosts[LAIR + ghost]--;
            boolean due = ghosts[LAIR + ghost] == 0
                    || state.levelTime == 0 && state.has(GameSwitch.GHOSTS_START_OUTSIDE_LAIR);
            if (!due) {
                continue;
            }
            if (state.has(GameSwitch.IMPRISONED_WHILE_EDIBLE) && state.isAnyEdible()) {
                ghosts[LAIR + ghost] += state.scaledTime(state.rules.ghosts().lairTime());
            } else {
                exit = true;
                ghosts = leaveLair(state, ghosts, ghost);
            }
        }
        if (exit && state.has(GameSwitch.SIMULTANEOUS_LAIR_EXIT)) {
            leaveLairTogether(state);
        }
    }

    private static void leaveLairTogether(GameState state) {
        for (int ghost = 0; ghost < state.rules.ghosts().activeGhosts(); ghost++) {
            state.ghosts[LAIR + ghost] = 0;
            if (state.ghostNode(ghost) == state.graph.lair()) {
                leaveLair(state, state.ghosts, ghost);
            }
        }
    }

    /**
     * Lets a ghost leave the lair, or starts the next level instead.
     *
     * <p>Quirk of the original: when a level starts here, the loop continues over the ghosts of the old level. Their
     * exits draw random numbers but have no effect.
     *
     * @return the ghosts over which the loop continues
     */
    private static int[] leaveLair(GameState state, int[] ghosts, int ghost) {
        if (state.levelTime > 0 && state.has(GameSwitch.ONLY_ONE_LAIR_EXIT)) {
            int[] old = ghosts.clone();
            return LevelStart.next(state) ? old : ghosts;
        }
        ghosts[POSE + ghost] = MazePoses.of(exitNode(state, ghost), MazePoses.move(ghosts[POSE + ghost]));
        state.minGhostDistance = 0;
        if (state.has(GameSwitch.EXIT_LAIR_EDIBLE)) {
            ghosts[EDIBLE + ghost] = state.newEdibleTime();
        }
        return ghosts;
    }

    private static int exitNode(GameState state, int ghost) {
        if (state.has(GameSwitch.RANDOM_LAIR_EXIT)) {
            return state.graph.junctionNode(state.taskRandom().nextInt(state.graph.junctionCount()));
        }
        if (state.has(GameSwitch.LAIR_EXIT_DATABASE)) {
            int observation = state.taskRandom().nextInt(GhostLocations.SITUATIONS);
            return Objects.requireNonNull(state.rules.ghosts().ghostLocations(), "the switch needs ghost locations")
                    .node(state.mazeIndex, state.rules.mazes().startingPowerPill(), observation, ghost);
        }
        return state.graph.ghostStart();
    }
}
