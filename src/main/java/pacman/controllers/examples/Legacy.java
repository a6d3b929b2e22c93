package pacman.controllers.examples;

import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * The ghost team of the published experiments: BLINKY, INKY and PINKY head for Ms.&nbsp;Pac-Man by three measures of
 * distance, SUE moves at random. It ignores edibility: edible ghosts keep heading for her, and only the reversal after
 * a power pill turns them away.
 *
 * <p>Source: Schrum and Miikkulainen 2016, section 4.1; docs/specification/controllers.md, section 5.4.
 */
public class Legacy extends ForgetfulGhostTeam {

    private static final GHOST[] ORDER = {GHOST.BLINKY, GHOST.INKY, GHOST.PINKY, GHOST.SUE};

    @Override
    GHOST[] order() {
        return ORDER;
    }

    @Override
    @Nullable
    MOVE choose(Game game, GHOST ghost, ResumableRandom random) {
        return switch (ghost) {
            case BLINKY -> towardsPacMan(game, ghost, DM.PATH);
            case INKY -> towardsPacMan(game, ghost, DM.MANHATTAN);
            case PINKY -> towardsPacMan(game, ghost, DM.EUCLID);
            case SUE -> randomMove(random);
        };
    }
}
