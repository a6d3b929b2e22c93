package pacman.entries.ghosts;

import java.util.EnumMap;
import pacman.controllers.Controller;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/** The skeleton of a competition entry: a ghost team that returns no moves. */
public class MyGhosts extends Controller<EnumMap<GHOST, MOVE>> {

    private final EnumMap<GHOST, MOVE> myMoves = new EnumMap<>(GHOST.class);

    @Override
    public EnumMap<GHOST, MOVE> getMove(Game game, long timeDue) {
        myMoves.clear();
        // Place your game logic here to play the game as the ghosts.
        return myMoves;
    }
}
