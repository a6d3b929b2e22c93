package pacman.game.internal;

import java.util.EnumMap;
import java.util.Map;
import pacman.game.Constants.MOVE;

/**
 * A node of the maze graph in the competition's interface.
 *
 * <p>Three tables have the last move as key: the move by which a walker entered this node. The entry of a last move
 * contains all neighbours but the one behind the walker. A last move by which this node cannot be entered has no entry.
 * NEUTRAL means that there was no last move; its entry contains all neighbours. Neighbours are in the order up, right,
 * down, left. All games share the tables: do not modify them.
 *
 * <p>Source: docs/specification/simulator.md, section 1.4.
 */
public final class Node {

    private static final MOVE[] MOVES = MOVE.values();

    /** Horizontal position in pixels. */
    public final int x;
    /** Vertical position in pixels, growing downwards. */
    public final int y;
    /** Number of this node: its index in {@link Maze#graph}. */
    public final int nodeIndex;
    /** Number of the pill on this node, -1 if none. */
    public final int pillIndex;
    /** Number of the power pill on this node, -1 if none. */
    public final int powerPillIndex;

    /** Number of neighbours. */
    public final int numNeighbouringNodes;
    /** Neighbours by direction; closed directions are absent. */
    public final EnumMap<MOVE, Integer> neighbourhood = new EnumMap<>(MOVE.class);
    /** Directions except back, by last move. */
    public EnumMap<MOVE, MOVE[]> allPossibleMoves = new EnumMap<>(MOVE.class);
    /** Neighbours except the one behind, by last move. */
    public EnumMap<MOVE, int[]> allNeighbouringNodes = new EnumMap<>(MOVE.class);
    /** Neighbours except the one behind, by last move and direction. */
    public EnumMap<MOVE, EnumMap<MOVE, Integer>> allNeighbourhoods = new EnumMap<>(MOVE.class);

    /**
     * A node.
     *
     * @param neighbourhood neighbours up, right, down and left, -1 if there is none
     */
    public Node(int nodeIndex, int x, int y, int pillIndex, int powerPillIndex, int[] neighbourhood) {
        this.nodeIndex = nodeIndex;
        this.x = x;
        this.y = y;
        this.pillIndex = pillIndex;
        this.powerPillIndex = powerPillIndex;
        for (int direction = 0; direction < neighbourhood.length; direction++) {
            if (neighbourhood[direction] != -1) {
                this.neighbourhood.put(MOVES[direction], neighbourhood[direction]);
            }
        }
        numNeighbouringNodes = this.neighbourhood.size();
        for (MOVE lastMove : MOVES) {
            if (lastMove == MOVE.NEUTRAL || this.neighbourhood.containsKey(lastMove.opposite())) {
                addTables(lastMove);
            }
        }
    }

    private void addTables(MOVE lastMove) {
        EnumMap<MOVE, Integer> ways = new EnumMap<>(neighbourhood);
        if (lastMove != MOVE.NEUTRAL) {
            ways.remove(lastMove.opposite());
        }
        allNeighbourhoods.put(lastMove, ways);
        MOVE[] moves = new MOVE[ways.size()];
        int[] nodes = new int[ways.size()];
        int count = 0;
        for (Map.Entry<MOVE, Integer> way : ways.entrySet()) {
            moves[count] = way.getKey();
            nodes[count++] = way.getValue();
        }
        allPossibleMoves.put(lastMove, moves);
        allNeighbouringNodes.put(lastMove, nodes);
    }
}
