package pacman.controllers;

import java.util.EnumMap;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;

/**
 * A ghost team that can be reset for another game. MM-NEAT added it to the competition's interface. Extend it if the
 * team keeps state from step to step and one object plays several games, as in an evolution; otherwise {@link
 * Controller} is enough.
 *
 * <p>Source: docs/specification/controllers.md, section 3.2.
 */
public abstract class NewGhostController extends Controller<EnumMap<GHOST, MOVE>> {

    /**
     * Makes the team ready for another game. The task of an evolution calls it before each game; {@link
     * pacman.Executor} does not call it.
     */
    public void reset() {
        threadRevive();
    }
}
