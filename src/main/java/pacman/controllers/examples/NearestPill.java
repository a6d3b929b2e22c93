package pacman.controllers.examples;

import org.jspecify.annotations.Nullable;
import pacman.game.Constants.DM;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/** The move towards the nearest pill, which Ms. Pac-Man makes if she has no other goal. */
final class NearestPill {

    private NearestPill() {}

    /**
     * Returns the direction to the nearest available pill or power pill. If none is left, it returns the first open
     * direction: the original then computes the path to node -1, which has distance 0 from every node.
     */
    static @Nullable MOVE moveTowards(Game game) {
        int position = game.getPacmanCurrentNodeIndex();
        int target = game.nearestPill(position);
        return target < 0
                ? game.getPossibleMoves(position)[0]
                : game.getNextMoveTowardsTarget(position, target, DM.PATH);
    }
}
