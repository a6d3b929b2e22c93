package mmneat.contest;

import java.time.Duration;
import java.util.EnumMap;
import org.jspecify.annotations.Nullable;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.GameRules;

/**
 * The settings of a contest.
 *
 * @param pacMan Ms. Pac-Man's side
 * @param ghosts the ghosts' side
 * @param rules of all games
 * @param games number of games, at least 1
 * @param seed seed from which the games' seeds are drawn
 * @param timing the time limit of controllers
 * @param moveLimit an untimed game fails if it makes no step for this long; null for no limit, and a stalled game is
 *     only reported
 * @param isShown whether the games are shown in a window
 * @param onFailure what to do with a game in which a controller failed
 * @param isRepeated whether the first finished game is played again to compare the scores
 */
public record ContestSettings(
        Contestant<MOVE> pacMan,
        Contestant<EnumMap<GHOST, MOVE>> ghosts,
        GameRules rules,
        int games,
        long seed,
        Timing timing,
        @Nullable Duration moveLimit,
        boolean isShown,
        OnFailure onFailure,
        boolean isRepeated) {}
