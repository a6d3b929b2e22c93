package pacman.controllers;

import mmneat.random.ResumableRandom;
import pacman.game.Game;

/**
 * A controller whose decision only reads the game, so that it can use the live game instead of a copy.
 *
 * <p>Controllers of the original draw random numbers from the generator of their copy of the game. {@link #decide}
 * receives this generator separately. {@link pacman.controllers.examples.LiveReaders} decides which controllers may
 * read the live game.
 *
 * @param <T> {@code MOVE} for Ms. Pac-Man, {@code EnumMap<GHOST, MOVE>} for the ghosts
 */
public interface ReadOnlyController<T> {

    /**
     * Returns the same answer as {@code getMove(copy, timeDue)} for a copy of {@code game}.
     *
     * @param game read, not changed
     * @param random the caller's generator, set by {@link Game#continueAsCopy}; the controller may draw from it
     */
    T decide(Game game, ResumableRandom random);
}
