package pacman.entries.ghosts;

import java.util.EnumMap;
import pacman.controllers.Controller;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * A skeleton to start your own ghost team from, for contests by the rules of the Ms.&nbsp;Pac-Man versus Ghosts
 * competition. As it stands, the map of moves is empty. Ghosts without a move go straight on, and at a wall in a random
 * direction other than back.
 *
 * <p>To use it, copy the class into a project of your own, which needs only {@code mmneat-simulator.jar}. Fill {@link
 * #getMove}: put a move for each ghost into the map in every step in which {@code game.doesGhostRequireAction(ghost)}
 * is true. Compile it and play: {@code java -jar mmneat.jar play classpath=FOLDER ghosts=MyGhosts view=true}. How to
 * write a controller: docs/competition.md.
 */
public class MyGhosts extends Controller<EnumMap<GHOST, MOVE>> {

    private final EnumMap<GHOST, MOVE> myMoves = new EnumMap<>(GHOST.class);

    /**
     * Returns the moves of the ghosts for the next step.
     *
     * @param game a copy of the game, which may be advanced to look ahead
     * @param timeDue time in milliseconds (as {@link System#currentTimeMillis}) by which the answer is due; -1 for none
     * @return a move for each ghost; a ghost without a move, or whose move is closed or leads back, goes straight on,
     *     and at a wall in a random direction
     */
    @Override
    public EnumMap<GHOST, MOVE> getMove(Game game, long timeDue) {
        myMoves.clear();
        // Place your game logic here to play the game as the ghosts.
        return myMoves;
    }
}
