package pacman.controllers.examples;

import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * As {@link Legacy}, but an edible BLINKY, INKY or PINKY flees; SUE is always random. Source:
 * docs/specification/controllers.md, section 5.2.
 */
public class ChaseFleeGhosts extends Legacy {

    @Override
    @Nullable
    MOVE choose(Game game, GHOST ghost, ResumableRandom random) {
        return ghost != GHOST.SUE && game.isGhostEdible(ghost)
                ? awayFromPacMan(game, ghost)
                : super.choose(game, ghost, random);
    }
}
