package pacman.game;

import static pacman.game.GameState.EDIBLE;
import static pacman.game.GameState.GHOSTS;
import static pacman.game.GameState.LAIR;
import static pacman.game.GameState.NO_MOVE;
import static pacman.game.GameState.POSE;

import pacman.game.Constants.GHOST;
import pacman.maze.MazePoses;

/**
 * The starts of levels and lives: positions, lair times and the pills of the next level.
 *
 * <p>Source: docs/specification/simulator.md, sections 2.7 and 2.8.
 */
final class LevelStart {

    private static final GHOST[] GHOST_TYPES = GHOST.values();

    private LevelStart() {}

    /** Moves Ms. Pac-Man and the ghosts to their start positions, as at the start of a level and after a death. */
    static void resetPositions(GameState state) {
        state.ghostMultiplier = 1;
        state.minGhostDistance = 0;
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            state.ghosts[POSE + ghost] = MazePoses.of(state.graph.lair(), NO_MOVE);
            state.ghosts[EDIBLE + ghost] = 0;
            state.ghosts[LAIR + ghost] = state.scaledTime(GHOST_TYPES[ghost].initialLairTime);
        }
        int powerPill = state.rules.mazes().startingPowerPill();
        int start = powerPill < 0 ? state.graph.pacManStart() : state.graph.powerPillNode(powerPill);
        state.pacManPose = MazePoses.of(start, Constants.MOVE.LEFT.ordinal());
    }

    /**
     * Starts the next level, or ends the game after the last.
     *
     * @return whether positions were reset; false after the last level
     */
    static boolean next(GameState state) {
        endLevel(state);
        if (state.rules.mazes().onlyMaze() < 0) {
            state.mazeIndex =
                    (state.mazeIndex + 1) % state.rules.mazes().mazes().count();
        }
        state.level++;
        state.timesLevel++;
        state.levelTime = 0;
        state.ghostMultiplier = 1;
        state.enterMaze();
        if (state.level >= state.rules.levels().maximumLevel()) {
            state.gameOver = true;
            return false;
        }
        LevelPills.fill(state);
        LevelPills.fillPowerPills(state);
        if (state.has(GameSwitch.REMOVE_PILLS_NEAR_POWER_PILLS)) {
            LevelPills.removeNearPowerPills(state);
        }
        resetPositions(state);
        return true;
    }

    private static void endLevel(GameState state) {
        if (state.history != null && state.isAnyEdible()) {
            state.history.timesToEatAll.add(GameHistory.NEVER);
        }
        if (state.rules.levels().creditForRemainingPills()) {
            int powerPillsLeft = Long.bitCount(state.powerPills);
            state.score += Constants.POWER_PILL / 2 * powerPillsLeft + Constants.PILL / 2 * state.pillsLeft;
            state.eatenPills += (powerPillsLeft + state.pillsLeft) / 2;
        }
        if (state.history != null) {
            state.history.closeLevel(state.score);
        }
    }
}
