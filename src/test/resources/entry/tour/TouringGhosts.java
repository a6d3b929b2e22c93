package tour;

import java.util.EnumMap;
import pacman.controllers.Controller;
import pacman.controllers.examples.Legacy;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/** A team that asks one of the examples. */
public class TouringGhosts extends Controller<EnumMap<GHOST, MOVE>> {

    private final Legacy legacy = new Legacy();

    @Override
    public EnumMap<GHOST, MOVE> getMove(Game game, long timeDue) {
        return legacy.getMove(game, timeDue);
    }
}
