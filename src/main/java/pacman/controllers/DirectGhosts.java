package pacman.controllers;

import java.util.EnumMap;
import mmneat.random.ResumableRandom;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GhostMoves;

/**
 * A ghost team that only reads the game and can say its moves without a map, whose filling and reading is a quarter of the
 * time of a plain game.
 *
 * <p>Only for teams that empty their map before each decision: what others keep in it may move a ghost.
 */
public interface DirectGhosts extends ReadOnlyController<EnumMap<GHOST, MOVE>> {

    /**
     * The same answer as {@link #decide}, as {@link GhostMoves}.
     *
     * @param game read, not changed
     * @param random a generator of the caller's, set by {@link Game#continueAsCopy}; it may be drawn from
     */
    int decideMoves(Game game, ResumableRandom random);
}
