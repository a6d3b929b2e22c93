package pacman.controllers.examples;

import java.util.EnumMap;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.controllers.NewGhostController;
import pacman.controllers.ReadOnlyController;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * Base class of the example ghost teams. It calls {@link #choose} for each ghost that requires an action, and stores
 * the answers in one map that the team reuses. Source: docs/specification/controllers.md, section 5.1.
 */
abstract class GhostTeam extends NewGhostController implements ReadOnlyController<EnumMap<GHOST, MOVE>> {

    private static final GHOST[] ENUM_ORDER = GHOST.values();
    private static final MOVE[] MOVES = MOVE.values();

    private EnumMap<GHOST, MOVE> moves = new EnumMap<>(GHOST.class);

    /** Returns the move of a ghost that requires an action. */
    abstract @Nullable MOVE choose(Game game, GHOST ghost, ResumableRandom random);

    /** Returns the order in which the ghosts choose, which is the order of their random draws. */
    GHOST[] order() {
        return ENUM_ORDER;
    }

    /** Whether the map is cleared before each decision. If not, it keeps old moves of ghosts that require no action. */
    boolean forgetsLastMoves() {
        return false;
    }

    @Override
    public EnumMap<GHOST, MOVE> getMove(Game game, long timeDue) {
        return decide(game, game.rnd);
    }

    @Override
    public EnumMap<GHOST, MOVE> decide(Game game, ResumableRandom random) {
        if (forgetsLastMoves()) {
            moves.clear();
        }
        for (GHOST ghost : order()) {
            if (game.doesGhostRequireAction(ghost)) {
                moves.put(ghost, choose(game, ghost, random));
            }
        }
        return moves;
    }

    @Override
    public void reset() {
        super.reset();
        forgetMap();
    }

    /** Starts with a new map; the map of the last game stays unchanged. */
    final void forgetMap() {
        moves = new EnumMap<>(GHOST.class);
    }

    /** The direction, without reversing, whose next node is nearest to Ms. Pac-Man; the rest of the way may reverse. */
    static @Nullable MOVE towardsPacMan(Game game, GHOST ghost, DM measure) {
        return game.getApproximateNextMoveTowardsTarget(
                game.getGhostCurrentNodeIndex(ghost),
                game.getPacmanCurrentNodeIndex(),
                game.getGhostLastMoveMade(ghost),
                measure);
    }

    /** The direction, without reversing, whose next node is farthest from Ms. Pac-Man by shortest path. */
    static @Nullable MOVE awayFromPacMan(Game game, GHOST ghost) {
        return game.getApproximateNextMoveAwayFromTarget(
                game.getGhostCurrentNodeIndex(ghost),
                game.getPacmanCurrentNodeIndex(),
                game.getGhostLastMoveMade(ghost),
                DM.PATH);
    }

    /** Draws one of the five moves, including NEUTRAL and the forbidden reverse. */
    static MOVE randomMove(ResumableRandom random) {
        return MOVES[random.nextInt(MOVES.length)];
    }

    /** Whether an available power pill is nearer to Ms. Pac-Man than {@code radius}, in steps of the shortest path. */
    static boolean isPacManNearPowerPill(Game game, int radius) {
        int pacMan = game.getPacmanCurrentNodeIndex();
        int[] powerPills = game.getPowerPillIndices();
        for (int i = 0; i < powerPills.length; i++) {
            if (game.isPowerPillStillAvailable(i) && game.getShortestPathDistance(powerPills[i], pacMan) < radius) {
                return true;
            }
        }
        return false;
    }
}
