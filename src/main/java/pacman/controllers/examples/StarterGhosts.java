package pacman.controllers.examples;

import java.util.Objects;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * Ghosts that flee when they are edible or Ms.&nbsp;Pac-Man is near a power pill; otherwise they usually attack and
 * sometimes move at random. Source: docs/specification/controllers.md, section 5.3.
 */
public final class StarterGhosts extends GhostTeam {

    /** Probability of attacking if the ghost does not flee. */
    private static final float ATTACK_PROBABILITY = 0.9f;

    /** Ms. Pac-Man is near a power pill if it is nearer than this, in steps. */
    private static final int POWER_PILL_RADIUS = 15;

    @Override
    @Nullable
    MOVE choose(Game game, GHOST ghost, ResumableRandom random) {
        if (game.getGhostEdibleTime(ghost) > 0 || isPacManNearPowerPill(game, POWER_PILL_RADIUS)) {
            return awayFromPacMan(game, ghost);
        }
        if (random.nextFloat() < ATTACK_PROBABILITY) {
            return towardsPacMan(game, ghost, DM.PATH);
        }
        MOVE[] possible = Objects.requireNonNull(
                game.getPossibleMoves(game.getGhostCurrentNodeIndex(ghost), game.getGhostLastMoveMade(ghost)));
        return possible[random.nextInt(possible.length)];
    }

    /**
     * Clears the map of moves. Quirk of MM-NEAT: unlike other teams, this one does not call {@link #threadRevive}.
     * After a timed game it therefore makes no decisions in a second timed game.
     */
    @Override
    public void reset() {
        forgetMap();
    }
}
