package pacman.controllers.examples;

import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * As {@link Legacy}, but all ghosts except BLINKY move at random. Source: docs/specification/controllers.md, section
 * 5.2.
 */
public class VeryRandomLegacy extends Legacy {

    @Override
    @Nullable
    MOVE choose(Game game, GHOST ghost, ResumableRandom random) {
        return ghost == GHOST.BLINKY ? super.choose(game, ghost, random) : randomMove(random);
    }
}
