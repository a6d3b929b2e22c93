package pacman.maze;

import java.util.Arrays;

/**
 * A table of the steps of ghosts: from each pose, the pose after one step straight on. A pose is a node together with
 * the move that led there, in one number. Immutable.
 *
 * <p>The game keeps the positions of Ms. Pac-Man and of the ghosts as poses. A ghost in a straight part of a corridor
 * repeats its move; at a bend, where {@link #onward} is -1, the engine takes the only direction that is not back.
 *
 * <p>Moves are 0 up, 1 right, 2 down, 3 left, 4 none.
 */
public final class MazePoses {

    /** Nodes for which poses fit the table, the lair included: three times what mazes have. */
    static final int MAXIMUM_NODES = 1 << 12;

    private static final int MOVE_BITS = 3;
    private static final int MOVE_MASK = (1 << MOVE_BITS) - 1;

    /** Pose after repeating the move of a pose, -1 if there is a wall; index pose. */
    private final short[] onward;

    /** Whether a ghost of a pose may choose where to go; index pose. */
    private final boolean[] choice;

    MazePoses(MazeGraph graph) {
        onward = new short[graph.nodeCount() << MOVE_BITS];
        Arrays.fill(onward, (short) -1);
        for (int node = 0; node < graph.nodeCount(); node++) {
            for (int move = 0; move < 4; move++) {
                int next = graph.neighbour(node, move);
                if (next >= 0) {
                    onward[of(node, move)] = (short) of(next, move);
                }
            }
        }
        choice = new boolean[onward.length];
        for (int pose = 0; pose < choice.length; pose++) {
            choice[pose] = graph.isJunction(node(pose));
        }
        choice[of(graph.ghostStart(), 4)] = true;
    }

    /** The pose after entering a node by a move, or without one. */
    public static int of(int node, int move) {
        return node << MOVE_BITS | move;
    }

    /** The node of a pose. */
    public static int node(int pose) {
        return pose >> MOVE_BITS;
    }

    /** The move of a pose, 0 to 4. */
    public static int move(int pose) {
        return pose & MOVE_MASK;
    }

    /** The same node, reached by another move. */
    public static int turned(int pose, int move) {
        return pose & ~MOVE_MASK | move;
    }

    /** Whether a ghost of that pose may choose: at a junction, or just out of the lair. */
    public boolean isChoice(int pose) {
        return choice[pose];
    }

    /** The pose after repeating the pose's move; -1 if a wall is there, or the move is none. */
    public int onward(int pose) {
        return onward[pose];
    }
}
