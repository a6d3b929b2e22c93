package pacman.entries.pacman;

import pacman.controllers.Controller;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * A skeleton to start your own controller of Ms.&nbsp;Pac-Man from, for contests by the rules of the Ms.&nbsp;Pac-Man
 * versus Ghosts competition. As it stands, she goes straight on and stops at walls.
 *
 * <p>To use it, copy the class into a project of your own, which needs only {@code mmneat-simulator.jar}. Fill {@link
 * #getMove}. Compile it and play: {@code java -jar mmneat.jar play classpath=FOLDER pacman=MyPacMan view=true}. How to
 * write a controller: docs/competition.md.
 */
public class MyPacMan extends Controller<MOVE> {

    private final MOVE myMove = MOVE.NEUTRAL;

    /**
     * Returns the move of Ms.&nbsp;Pac-Man for the next step.
     *
     * @param game a copy of the game, which may be advanced to look ahead
     * @param timeDue time in milliseconds (as {@link System#currentTimeMillis}) by which the answer is due; -1 for none
     * @return a direction; if it is closed or {@code NEUTRAL}, she goes straight on, and at a wall she stops
     */
    @Override
    public MOVE getMove(Game game, long timeDue) {
        // Place your game logic here to play the game as Ms. Pac-Man.
        return myMove;
    }
}
