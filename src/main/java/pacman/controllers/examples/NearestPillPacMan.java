package pacman.controllers.examples;

import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.controllers.Controller;
import pacman.controllers.ReadOnlyController;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * A Ms.&nbsp;Pac-Man that heads for the nearest pill or power pill and ignores the ghosts. Source:
 * docs/specification/controllers.md, section 5.5.
 */
public class NearestPillPacMan extends Controller<MOVE> implements ReadOnlyController<MOVE> {

    @Override
    public @Nullable MOVE getMove(Game game, long timeDue) {
        return decide(game, game.rnd);
    }

    @Override
    public @Nullable MOVE decide(Game game, ResumableRandom random) {
        return NearestPill.moveTowards(game);
    }
}
