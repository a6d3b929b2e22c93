package pacman.controllers.examples;

import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.controllers.Controller;
import pacman.controllers.ReadOnlyController;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * A Ms.&nbsp;Pac-Man that draws one of the open directions except the reverse. Source:
 * docs/specification/controllers.md, section 5.5.
 */
public final class RandomNonRevPacMan extends Controller<MOVE> implements ReadOnlyController<MOVE> {

    @Override
    public @Nullable MOVE getMove(Game game, long timeDue) {
        return decide(game, game.rnd);
    }

    @Override
    public MOVE decide(Game game, ResumableRandom random) {
        int node = game.getPacmanCurrentNodeIndex();
        MOVE[] possible = game.getPossibleMoves(node, game.getPacmanLastMoveMade());
        if (possible == null) {
            // No other direction is open, for example at the start in a user's maze.
            possible = game.getPossibleMoves(node);
        }
        return possible[random.nextInt(possible.length)];
    }
}
