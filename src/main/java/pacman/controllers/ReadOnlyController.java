package pacman.controllers;

import mmneat.random.ResumableRandom;
import pacman.game.Game;

/**
 * A controller whose decision only reads the game, so that it may look at the live game instead of a copy.
 *
 * <p>A controller that draws random numbers draws them, as every controller of the original does, from the generator of
 * its copy of the game. {@link #decide} gets that generator apart. {@link pacman.controllers.examples.LiveReaders} says which
 * controllers are trusted with the live game.
 *
 * @param <T> {@code MOVE} for Ms. Pac-Man, {@code EnumMap<GHOST, MOVE>} for the ghosts
 */
public interface ReadOnlyController<T> {

    /**
     * The same answer as {@code getMove(copy, timeDue)}, where {@code copy} is a copy of {@code game}.
     *
     * @param game read, not changed
     * @param random a generator of the caller's, set by {@link Game#continueAsCopy}; it may be drawn from
     */
    T decide(Game game, ResumableRandom random);
}
