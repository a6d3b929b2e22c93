package pacman.controllers;

import java.util.EnumMap;
import mmneat.random.ResumableRandom;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GhostMoves;

/**
 * A ghost team that can return its moves as one int ({@link GhostMoves}) instead of a map. The map remains:
 * {@link #decide} of {@link ReadOnlyController} returns it, and {@code getMove} as for every ghost
 * team. A class that implements this interface writes all three; untimed games call {@link #decideMoves}. The int is
 * the faster form: filling and reading a map takes a quarter of the time of an untimed game without networks.
 *
 * <p>Both forms must mean the same. So only a team that clears its map before each decision may implement this
 * interface. In other teams an old entry of the map can still move a ghost; the int has no old entries. Only examples
 * of this program gain by it ({@link ReadOnlyController}).
 */
public interface DirectGhosts extends ReadOnlyController<EnumMap<GHOST, MOVE>> {

    /**
     * Returns the same answer as {@link #decide}, encoded as {@link GhostMoves}.
     *
     * @param game read, not changed
     * @param random the caller's generator, set by {@link Game#continueAsCopy}; the controller may draw from it
     */
    int decideMoves(Game game, ResumableRandom random);
}
