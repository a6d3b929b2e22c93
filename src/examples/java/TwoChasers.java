import java.util.EnumMap;
import mmneat.cli.Main;
import pacman.controllers.NewGhostController;
import pacman.game.Constants.*;
import pacman.game.Game;

/** A ghost team: Blinky and Sue chase her, the others go straight on and turn at random. */
public class TwoChasers extends NewGhostController {
    public EnumMap<GHOST, MOVE> getMove(Game game, long timeDue) {
        EnumMap<GHOST, MOVE> moves = new EnumMap<>(GHOST.class);
        for (GHOST ghost : new GHOST[] {GHOST.BLINKY, GHOST.SUE}) {
            int from = game.getGhostCurrentNodeIndex(ghost);
            MOVE last = game.getGhostLastMoveMade(ghost);
            int to = game.getPacmanCurrentNodeIndex();
            moves.put(ghost, game.getApproximateNextMoveTowardsTarget(from, to, last, DM.PATH));
        }
        return moves;
    }

    public static void main(String[] arguments) {
        Main.main("task=blended ghostTeam=TwoChasers mu=10 maxGens=3 trials=2 base=results/chasers".split(" "));
    }
}
