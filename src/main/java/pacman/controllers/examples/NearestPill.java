package pacman.controllers.examples;

import pacman.game.Constants.DM;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/** What Ms. Pac-Man does when nothing else matters. */
final class NearestPill {

    private NearestPill() {}

    /**
     * The direction of the nearest pill or power pill present. If nothing is left, the first direction that is open: the
     * original then asks for the way to node -1, whose distance from everywhere is 0.
     */
    static MOVE moveTowards(Game game) {
        int position = game.getPacmanCurrentNodeIndex();
        int target = game.nearestPill(position);
        return target < 0
                ? game.getPossibleMoves(position)[0]
                : game.getNextMoveTowardsTarget(position, target, DM.PATH);
    }
}
