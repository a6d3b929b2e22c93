package mmneat.analysis.replay;

/**
 * One time step of a game: the state before the move and the decision taken in it. The object is reused: the caller
 * sets its fields in every step, and {@link ReplayRecorder#record} copies them. Directions are UP 0, RIGHT 1, DOWN 2,
 * LEFT 3; ghosts Blinky 0, Pinky 1, Inky 2, Sue 3; moves are directions or {@link #NO_MOVE}.
 */
public final class ReplayStep {

    /** The neutral move. */
    public static final int NO_MOVE = 4;

    /** Index of the maze, as in {@link ReplayMaze#index}. */
    public int maze;

    /** Level of the game, from 0; a new level starts with new pills. */
    public int level;

    /** Steps since the level began. */
    public int levelTime;

    /** Score so far. */
    public int score;

    /** Lives left, the present one included. */
    public int lives;

    /** Ms. Pac-Man's node. */
    public int pacMan;

    /** Ms. Pac-Man's last move. */
    public int pacManMove;

    /** Node of each ghost. */
    public final int[] ghosts = new int[4];

    /** The last move of each ghost. */
    public final int[] ghostMoves = new int[4];

    /** Number of steps for which each ghost stays edible; 0 if it is a threat. */
    public final int[] edibleTimes = new int[4];

    /** Number of steps for which each ghost stays in the lair; 0 if it is outside. */
    public final int[] lairTimes = new int[4];

    /** For each pill of the maze whether it is there. */
    public boolean[] pills = new boolean[0];

    /** For each power pill of the maze whether it is there. */
    public boolean[] powerPills = new boolean[0];

    /** Module that decided in the chosen direction; -1 in the last state of a game, which has no decision. */
    public int module = -1;

    /** The direction chosen, or {@link #NO_MOVE}. */
    public int choice = NO_MOVE;

    /**
     * For each direction whether it is open, without a wall. For closed directions {@link #preferences}, {@link
     * #modules}, {@link #sensors} and {@link #activations} are ignored.
     */
    public final boolean[] open = new boolean[4];

    /** The network's output for each open direction, in [-1, 1]. */
    public final double[] preferences = new double[4];

    /** Module that gave the output of each open direction. */
    public final int[] modules = new int[4];

    /** Sensor values, [direction][input], in [-1, 1]. */
    public final double[][] sensors;

    /** Activations of the hidden and output nodes, [direction][node], in [-1, 1]. */
    public final double[][] activations;

    /** A step for a network of this size. */
    public ReplayStep(ReplayNetwork network) {
        sensors = new double[4][network.inputs().size()];
        activations = new double[4][network.nodes().size()];
    }
}
