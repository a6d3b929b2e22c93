package pacman.controllers;

import java.util.EnumMap;
import mmneat.random.ResumableRandom;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GhostMoves;

/**
 * A ghost team that only reads the game and returns its moves without a map. Filling and reading a map takes a quarter
 * of the time of a plain game.
 *
 * <p>It is only for teams that clear their map before each decision; in other teams an old entry of the map may move a
 * ghost.
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
