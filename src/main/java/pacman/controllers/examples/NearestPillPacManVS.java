package pacman.controllers.examples;

import java.awt.Color;
import org.jspecify.annotations.Nullable;
import pacman.controllers.Controller;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GameView;

/**
 * As {@link NearestPillPacMan}, with an example of drawing into the view: BLINKY's path to the first power pill, in red
 * with reversing allowed, in yellow without. Source: docs/specification/controllers.md, section 5.5.
 */
public final class NearestPillPacManVS extends Controller<MOVE> {

    @Override
    public @Nullable MOVE getMove(Game game, long timeDue) {
        int[] powerPills = game.getActivePowerPillsIndices();
        if (game.getGhostLairTime(GHOST.BLINKY) == 0 && powerPills.length > 0) {
            int blinky = game.getGhostCurrentNodeIndex(GHOST.BLINKY);
            GameView.addPoints(game, Color.RED, game.getShortestPath(blinky, powerPills[0], MOVE.NEUTRAL));
            GameView.addPoints(
                    game,
                    Color.YELLOW,
                    game.getShortestPath(blinky, powerPills[0], game.getGhostLastMoveMade(GHOST.BLINKY)));
        }
        return NearestPill.moveTowards(game);
    }
}
