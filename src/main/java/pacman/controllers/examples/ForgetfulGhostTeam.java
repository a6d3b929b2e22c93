package pacman.controllers.examples;

import mmneat.random.ResumableRandom;
import pacman.controllers.DirectGhosts;
import pacman.game.Constants.GHOST;
import pacman.game.Game;
import pacman.game.GhostMoves;

/**
 * Base class of the example ghost teams that clear their map of moves before each decision. The map then holds the new
 * moves only, so that the team can also return them without a map ({@link DirectGhosts}).
 */
abstract class ForgetfulGhostTeam extends GhostTeam implements DirectGhosts {

    @Override
    final boolean forgetsLastMoves() {
        return true;
    }

    @Override
    public final int decideMoves(Game game, ResumableRandom random) {
        int asked = game.ghostsRequiringAction();
        int answers = GhostMoves.NONE;
        if (asked == 0) {
            return answers;
        }
        for (GHOST ghost : order()) {
            if ((asked >>> ghost.ordinal() & 1) != 0) {
                answers = GhostMoves.with(answers, ghost, choose(game, ghost, random));
            }
        }
        return answers;
    }
}
