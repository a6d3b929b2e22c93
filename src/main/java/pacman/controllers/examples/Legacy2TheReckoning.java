package pacman.controllers.examples;

import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * Ghosts that spread to their corners when they are crowded, flee when they are edible or Ms.&nbsp;Pac-Man is near a
 * power pill, and chase her otherwise. Source: docs/specification/controllers.md, section 5.3.
 */
public class Legacy2TheReckoning extends GhostTeam {

    /** The ghosts are crowded if their average distance from each other is below this, in steps. */
    public static final int CROWDED_DISTANCE = 30;

    /**
     * A ghost nearer to Ms.&nbsp;Pac-Man than this, in steps, does not go to its corner when the ghosts are crowded.
     */
    public static final int PACMAN_DISTANCE = 10;

    /** Ms.&nbsp;Pac-Man is near a power pill if it is nearer than this, in steps. */
    public static final int PILL_PROXIMITY = 15;

    private static final GHOST[] GHOSTS = GHOST.values();
    private static final int PAIRS = 6;

    @Override
    @Nullable
    MOVE choose(Game game, GHOST ghost, ResumableRandom random) {
        if (areCrowded(game) && !isNearPacMan(game, ghost) && game.getNumberOfPowerPills() > 0) {
            return towardsItsCorner(game, ghost);
        }
        if (game.getGhostEdibleTime(ghost) > 0 || isPacManNearPowerPill(game, PILL_PROXIMITY)) {
            return awayFromPacMan(game, ghost);
        }
        return towardsPacMan(game, ghost, DM.PATH);
    }

    /** Pairs with a ghost in the lair have distance -1, or 0 if both are there. */
    private static boolean areCrowded(Game game) {
        float sum = 0;
        for (int i = 0; i < GHOSTS.length; i++) {
            for (int j = i + 1; j < GHOSTS.length; j++) {
                sum += game.getShortestPathDistance(
                        game.getGhostCurrentNodeIndex(GHOSTS[i]), game.getGhostCurrentNodeIndex(GHOSTS[j]));
            }
        }
        return sum / PAIRS < CROWDED_DISTANCE;
    }

    private static boolean isNearPacMan(Game game, GHOST ghost) {
        return game.getShortestPathDistance(game.getPacmanCurrentNodeIndex(), game.getGhostCurrentNodeIndex(ghost))
                < PACMAN_DISTANCE;
    }

    /** Returns the direction to the node of the power pill in the ghost's corner, even if that pill has been eaten. */
    private static @Nullable MOVE towardsItsCorner(Game game, GHOST ghost) {
        int corner =
                switch (ghost) {
                    case BLINKY -> 0;
                    case INKY -> 1;
                    case PINKY -> 2;
                    case SUE -> 3;
                };
        int[] powerPills = game.getPowerPillIndices();
        return game.getApproximateNextMoveTowardsTarget(
                game.getGhostCurrentNodeIndex(ghost),
                powerPills[corner % powerPills.length],
                game.getGhostLastMoveMade(ghost),
                DM.PATH);
    }
}
