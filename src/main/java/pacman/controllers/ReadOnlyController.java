package pacman.controllers;

import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Game;

/**
 * A controller whose decision only reads the game, so that untimed games can pass it the live game instead of a copy.
 *
 * <p>The interface is for the example controllers of this program; it is public because they are in another package.
 * {@link pacman.controllers.examples.LiveReaders} decides which controllers may read the live game. An entry never gets
 * it: {@link #decide} of an entry is not called, and {@code getMove} is called with a copy.
 *
 * <p>A controller usually draws random numbers from the generator of its copy of the game. Without a copy, {@link
 * #decide} receives a generator in the same state as a separate argument.
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
    @Nullable
    T decide(Game game, ResumableRandom random);
}
