package pacman.game;

import org.jspecify.annotations.Nullable;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;

/**
 * An encoding of the moves of the four ghosts in one {@code int}. A ghost team may return it instead of the
 * competition's map, which takes time to fill and read. {@link MOVE#NEUTRAL} means that no move is requested for a
 * ghost.
 *
 * <p>{@value #BITS} bits per ghost hold the ordinal of its move, BLINKY's the lowest.
 */
public final class GhostMoves {

    static final int BITS = 3;
    static final int MASK = 7;

    /** No move is requested for any ghost. */
    public static final int NONE = packed(null, null, null, null);

    private static final MOVE[] MOVES = MOVE.values();

    private GhostMoves() {}

    /** Returns the moves with that of one ghost replaced; null is the same as NEUTRAL. */
    public static int with(int moves, GHOST ghost, @Nullable MOVE move) {
        int shift = BITS * ghost.ordinal();
        return moves & ~(MASK << shift) | request(move) << shift;
    }

    /** Returns the move of a ghost. */
    public static MOVE get(int moves, GHOST ghost) {
        return MOVES[of(moves, ghost.ordinal())];
    }

    static int of(int moves, int ghost) {
        return moves >>> BITS * ghost & MASK;
    }

    static int packed(@Nullable MOVE blinky, @Nullable MOVE pinky, @Nullable MOVE inky, @Nullable MOVE sue) {
        return request(blinky) | request(pinky) << BITS | request(inky) << 2 * BITS | request(sue) << 3 * BITS;
    }

    static int request(@Nullable MOVE move) {
        return move == null ? GameState.NO_MOVE : move.ordinal();
    }
}
