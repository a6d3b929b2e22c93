package mmneat.contest;

import java.time.Duration;
import java.util.EnumMap;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.GameRules;

/**
 * What a contest is.
 *
 * @param pacMan Ms. Pac-Man's side
 * @param ghosts the ghosts' side
 * @param rules of all games
 * @param games number of games, at least 1
 * @param seed seed of the games' seeds
 * @param timing how long the controllers may take
 * @param moveLimit an untimed game fails when it does not go on for so long; null for no limit
 * @param isShown whether the games are shown in a window
 * @param onFailure what becomes of a game in which a controller failed
 * @param isRepeated whether the first finished game is played again to see whether it scores the same
 */
public record ContestSettings(
        Contestant<MOVE> pacMan,
        Contestant<EnumMap<GHOST, MOVE>> ghosts,
        GameRules rules,
        int games,
        long seed,
        Timing timing,
        Duration moveLimit,
        boolean isShown,
        OnFailure onFailure,
        boolean isRepeated) {}
