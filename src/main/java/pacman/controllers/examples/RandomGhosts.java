package pacman.controllers.examples;

import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * A ghost team in which each ghost that requires an action draws one of the five moves. Source:
 * docs/specification/controllers.md, section 5.2.
 */
public final class RandomGhosts extends ForgetfulGhostTeam {

    @Override
    @Nullable
    MOVE choose(Game game, GHOST ghost, ResumableRandom random) {
        return randomMove(random);
    }
}
