import pacman.Executor;
import pacman.controllers.Controller;
import pacman.controllers.examples.Legacy;
import pacman.game.Constants.*;
import pacman.game.Game;

/** A Ms. Pac-Man controller: flees from a ghost that is close, and else goes to the nearest pill. */
public class Careful extends Controller<MOVE> {
    public MOVE getMove(Game game, long timeDue) {
        int here = game.getPacmanCurrentNodeIndex();
        for (GHOST ghost : GHOST.values()) {
            int there = game.getGhostCurrentNodeIndex(ghost);
            if (game.getGhostLairTime(ghost) == 0 && game.getShortestPathDistance(here, there) < 20) {
                return game.getNextMoveAwayFromTarget(here, there, DM.PATH);
            }
        }
        int pill = game.getClosestNodeIndexFromNodeIndex(here, game.getActivePillsIndices(), DM.PATH);
        return game.getNextMoveTowardsTarget(here, pill, DM.PATH);
    }

    public static void main(String[] arguments) {
        new Executor().runExperiment(new Careful(), new Legacy(), 10);
    }
}
