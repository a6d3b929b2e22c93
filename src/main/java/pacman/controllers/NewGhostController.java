package pacman.controllers;

import java.util.EnumMap;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;

/** A ghost team that can be reset for another game. Source: docs/specification/controllers.md, section 3.2. */
public abstract class NewGhostController extends Controller<EnumMap<GHOST, MOVE>> {

    /** Called before a game. */
    public void reset() {
        threadRevive();
    }
}
