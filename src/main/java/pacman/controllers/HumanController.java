package pacman.controllers;

import java.awt.event.KeyEvent;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * The controller of a human player, who moves Ms.&nbsp;Pac-Man with the arrow keys. The executor attaches {@link
 * #input} to the game's window in timed games.
 */
public class HumanController extends Controller<MOVE> {

    /** The source of key presses; public in the competition's interface. */
    public KeyBoardInput input;

    public HumanController(KeyBoardInput input) {
        this.input = input;
    }

    public KeyBoardInput getKeyboardInput() {
        return input;
    }

    @Override
    public MOVE getMove(Game game, long timeDue) {
        return switch (input.getKey()) {
            case KeyEvent.VK_UP -> MOVE.UP;
            case KeyEvent.VK_RIGHT -> MOVE.RIGHT;
            case KeyEvent.VK_DOWN -> MOVE.DOWN;
            case KeyEvent.VK_LEFT -> MOVE.LEFT;
            default -> MOVE.NEUTRAL;
        };
    }
}
