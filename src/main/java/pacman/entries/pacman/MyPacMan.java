package pacman.entries.pacman;

import pacman.controllers.Controller;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/** The skeleton of a competition entry: a controller that lets Ms.&nbsp;Pac-Man go straight on. */
public class MyPacMan extends Controller<MOVE> {

    private final MOVE myMove = MOVE.NEUTRAL;

    @Override
    public MOVE getMove(Game game, long timeDue) {
        // Place your game logic here to play the game as Ms. Pac-Man.
        return myMove;
    }
}
