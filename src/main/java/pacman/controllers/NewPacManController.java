package pacman.controllers;

import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * A Ms.&nbsp;Pac-Man controller that returns a direction number and can request the end of the game.
 *
 * <p>An exception in {@link #getAction} is printed, and the stored answer of the last timed decision is used instead.
 * In untimed games there is no such answer, which ends the game under MM-NEAT's rules.
 *
 * <p>Source: docs/specification/controllers.md, section 3.1.
 */
public abstract class NewPacManController extends Controller<MOVE> {

    /** The action that requests the end of the game. */
    public static final int END_GAME_CODE = 27;

    private static final MOVE[] MOVES = MOVE.values();

    /** Number of real directions: 0 UP, 1 RIGHT, 2 DOWN, 3 LEFT. */
    private static final int DIRECTIONS = 4;

    /**
     * Returns the decision as a number.
     *
     * @return 0 UP, 1 RIGHT, 2 DOWN, 3 LEFT, {@link #END_GAME_CODE} to end the game; any other number is NEUTRAL
     */
    public abstract int getAction(Game game, long timeDue);

    /** Called after a game, to log the controller's observations. */
    public abstract void logEvaluationDetails();

    /** Called before a game. */
    public void reset() {
        threadRevive();
    }

    @Override
    public MOVE getMove(Game game, long timeDue) {
        try {
            int action = getAction(game, timeDue);
            if (action == END_GAME_CODE) {
                return null;
            }
            return action >= 0 && action < DIRECTIONS ? MOVES[action] : MOVE.NEUTRAL;
        } catch (Exception e) {
            System.out.println("Move failure");
            e.printStackTrace();
            System.out.println("Resort to previous move");
            return getMove();
        }
    }
}
