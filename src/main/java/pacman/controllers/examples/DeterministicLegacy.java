package pacman.controllers.examples;

import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * As {@link Legacy}, but SUE behaves like BLINKY, so that nothing is random. Source: docs/specification/controllers.md,
 * section 5.2.
 */
public class DeterministicLegacy extends Legacy {

    @Override
    @Nullable
    MOVE choose(Game game, GHOST ghost, ResumableRandom random) {
        return ghost == GHOST.SUE ? towardsPacMan(game, ghost, DM.PATH) : super.choose(game, ghost, random);
    }
}
