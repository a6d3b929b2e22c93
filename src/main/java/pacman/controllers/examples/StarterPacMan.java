package pacman.controllers.examples;

import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.controllers.NewPacManController;
import pacman.controllers.ReadOnlyController;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * A Ms.&nbsp;Pac-Man that flees from a threat, else chases the nearest edible ghost, else heads for the nearest pill.
 * She flees from the first ghost, in the order of {@link GHOST}, that is a threat less than 20 steps away. Source:
 * docs/specification/controllers.md, section 5.5.
 */
public class StarterPacMan extends NewPacManController implements ReadOnlyController<MOVE> {

    /** Ms. Pac-Man flees from a ghost nearer than this, in steps. */
    private static final int MINIMUM_DISTANCE = 20;

    private static final GHOST[] GHOSTS = GHOST.values();

    @Override
    public @Nullable MOVE getMove(Game game, long timeDue) {
        return decide(game, game.rnd);
    }

    @Override
    public @Nullable MOVE decide(Game game, ResumableRandom random) {
        int position = game.getPacmanCurrentNodeIndex();
        for (GHOST ghost : GHOSTS) {
            if (game.getGhostEdibleTime(ghost) == 0 && game.getGhostLairTime(ghost) == 0) {
                int node = game.getGhostCurrentNodeIndex(ghost);
                if (game.getShortestPathDistance(position, node) < MINIMUM_DISTANCE) {
                    return game.getNextMoveAwayFromTarget(position, node, DM.PATH);
                }
            }
        }
        int prey = nearestEdibleGhost(game, position);
        if (prey >= 0) {
            return game.getNextMoveTowardsTarget(position, prey, DM.PATH);
        }
        return NearestPill.moveTowards(game);
    }

    /** Returns the node of the nearest edible ghost, of equally near ones the first; -1 if no ghost is edible. */
    private static int nearestEdibleGhost(Game game, int position) {
        int nearest = -1;
        int smallest = Integer.MAX_VALUE;
        for (GHOST ghost : GHOSTS) {
            if (game.getGhostEdibleTime(ghost) > 0) {
                int node = game.getGhostCurrentNodeIndex(ghost);
                int distance = game.getShortestPathDistance(position, node);
                if (distance < smallest) {
                    smallest = distance;
                    nearest = node;
                }
            }
        }
        return nearest;
    }

    /** Not used: this controller returns a move. */
    @Override
    public int getAction(Game game, long timeDue) {
        throw new UnsupportedOperationException("StarterPacMan answers with a move; call getMove");
    }

    /** There is nothing to log. */
    @Override
    public void logEvaluationDetails() {}
}
