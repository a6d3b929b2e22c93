package pacman.controllers.examples;

import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * As {@link Legacy}, except that BLINKY compares the lengths of paths on which a ghost never reverses. Legacy compares
 * shortest distances, on which a ghost may reverse after its first step. Source: docs/specification/controllers.md,
 * section 5.2.
 */
public class BetterLegacy extends Legacy {

    @Override
    @Nullable
    MOVE choose(Game game, GHOST ghost, ResumableRandom random) {
        return switch (ghost) {
            case BLINKY -> exactlyTowardsPacMan(game, ghost, DM.PATH);
            case INKY -> exactlyTowardsPacMan(game, ghost, DM.MANHATTAN);
            case PINKY -> exactlyTowardsPacMan(game, ghost, DM.EUCLID);
            case SUE -> randomMove(random);
        };
    }

    private static @Nullable MOVE exactlyTowardsPacMan(Game game, GHOST ghost, DM measure) {
        return game.getNextMoveTowardsTarget(
                game.getGhostCurrentNodeIndex(ghost),
                game.getPacmanCurrentNodeIndex(),
                game.getGhostLastMoveMade(ghost),
                measure);
    }
}
