package pacman.controllers.examples;

import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * A ghost team in which each ghost heads for Ms.&nbsp;Pac-Man with a given probability and moves at random otherwise.
 * Source: docs/specification/controllers.md, section 5.2.
 */
public final class AggressiveGhosts extends ForgetfulGhostTeam {

    /** Default of the original's parameter {@code aggressiveGhostConsistency}. */
    private static final double DEFAULT_CONSISTENCY = 0.9;

    private final double consistency;

    /** Ghosts that head for Ms.&nbsp;Pac-Man in nine of ten decisions. */
    public AggressiveGhosts() {
        this(DEFAULT_CONSISTENCY);
    }

    /** @param consistency probability of heading for Ms. Pac-Man, in [0, 1] */
    public AggressiveGhosts(double consistency) {
        if (!(consistency >= 0 && consistency <= 1)) {
            throw new IllegalArgumentException("consistency must be in [0, 1], is " + consistency);
        }
        this.consistency = consistency;
    }

    @Override
    @Nullable
    MOVE choose(Game game, GHOST ghost, ResumableRandom random) {
        return random.nextFloat() < consistency ? towardsPacMan(game, ghost, DM.PATH) : randomMove(random);
    }
}
