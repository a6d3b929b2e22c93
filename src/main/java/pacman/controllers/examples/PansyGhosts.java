package pacman.controllers.examples;

import java.util.EnumMap;
import pacman.controllers.Controller;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/** Ghosts that always run away from Ms.&nbsp;Pac-Man. Source: docs/specification/controllers.md, section 5.2. */
public final class PansyGhosts extends Controller<EnumMap<GHOST, MOVE>> {

    private static final GHOST[] GHOSTS = GHOST.values();

    private final EnumMap<GHOST, MOVE> moves = new EnumMap<>(GHOST.class);

    @Override
    public EnumMap<GHOST, MOVE> getMove(Game game, long timeDue) {
        moves.clear();
        for (GHOST ghost : GHOSTS) {
            if (game.doesGhostRequireAction(ghost)) {
                // The original draws whether to flee, with a probability of 1 and from a separate generator.
                moves.put(ghost, GhostTeam.awayFromPacMan(game, ghost));
            }
        }
        return moves;
    }
}
