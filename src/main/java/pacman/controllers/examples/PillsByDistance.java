package pacman.controllers.examples;

import pacman.game.Constants.DM;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/** Finds the nearest available pill or power pill. */
final class PillsByDistance {

    /**
     * The direction of the nearest available pill or power pill by path distance; pills before power pills, each in the
     * order of their numbers, where distances are equal. NEUTRAL if nothing is left.
     */
    MOVE moveTowardsNearest(Game game) {
        int position = game.getPacmanCurrentNodeIndex();
        int nearest = nearest(game, position);
        return nearest < 0 ? MOVE.NEUTRAL : game.getNextMoveTowardsTarget(position, nearest, DM.PATH);
    }

    private static int nearest(Game game, int position) {
        int[] pills = game.getActivePillsIndices();
        int[] powerPills = game.getActivePowerPillsIndices();
        int[] targets = new int[pills.length + powerPills.length];
        System.arraycopy(pills, 0, targets, 0, pills.length);
        System.arraycopy(powerPills, 0, targets, pills.length, powerPills.length);
        return game.getClosestNodeIndexFromNodeIndex(position, targets, DM.PATH);
    }
}
