package pacman.controllers;

import org.jspecify.annotations.Nullable;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * A Ms.&nbsp;Pac-Man controller that returns a direction number and can request the end of the game.
 *
 * <p>If {@link #getAction} throws an exception, the exception is printed and the stored answer of the last timed
 * decision is returned instead. In untimed games no answer is stored, so that null is returned. By MM-NEAT's
 * conventions null ends the game from the twelfth step on ({@link Game#advanceGame(MOVE, java.util.EnumMap)}).
 *
 * <p>Source: docs/specification/controllers.md, section 3.1.
 */
public abstract class NewPacManController extends Controller<MOVE> {

    /**
     * The action that requests the end of the game; {@link #getMove(Game, long)} then returns null. It works by
     * MM-NEAT's conventions from the twelfth step on. By the competition's conventions null is only an illegal move.
     */
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

    /** Logs the controller's observations after a game. The caller of the game may call it; this program does not. */
    public abstract void logEvaluationDetails();

    /**
     * Makes the controller ready for another game. The caller of the game may call it; {@link pacman.Executor} does
     * not.
     */
    public void reset() {
        threadRevive();
    }

    @Override
    public @Nullable MOVE getMove(Game game, long timeDue) {
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
