package mmneat.analysis.replay;

/**
 * One time step of a game: the state before the move and the decision taken in it. Filled anew for every step and copied by
 * {@link ReplayRecorder#record}. Directions are UP 0, RIGHT 1, DOWN 2, LEFT 3; ghosts Blinky 0, Pinky 1, Inky 2, Sue 3; moves
 * are directions or {@link #NO_MOVE}.
 */
public final class ReplayStep {

    /** A move that goes nowhere. */
    public static final int NO_MOVE = 4;

    /** Index of the maze, as in {@link ReplayMaze#index}. */
    public int maze;

    /** Level of the game, from 0; a new level starts with new pills. */
    public int level;

    /** Steps since the level began. */
    public int levelTime;

    /** Points so far. */
    public int score;

    /** Lives left, the present one included. */
    public int lives;

    /** Ms. Pac-Man's node. */
    public int pacMan;

    /** The move she made last. */
    public int pacManMove;

    /** Node of each ghost. */
    public final int[] ghosts = new int[4];

    /** The move each ghost made last. */
    public final int[] ghostMoves = new int[4];

    /** Steps for which each ghost stays edible; 0: a threat. */
    public final int[] edibleTimes = new int[4];

    /** Steps for which each ghost stays in the lair; 0: outside. */
    public final int[] lairTimes = new int[4];

    /** For each pill of the maze whether it is there. */
    public boolean[] pills = new boolean[0];

    /** For each power pill of the maze whether it is there. */
    public boolean[] powerPills = new boolean[0];

    /** Module of the network that was asked in the chosen direction; -1 in the last state, in which nothing is decided. */
    public int module = -1;

    /** The direction chosen, or {@link #NO_MOVE}. */
    public int choice = NO_MOVE;

    /** For each direction whether there is a way; without a way the values below are ignored. */
    public final boolean[] open = new boolean[4];

    /** The network's wish for each open direction, in [-1, 1]. */
    public final double[] preferences = new double[4];

    /** Module that spoke for each open direction. */
    public final int[] modules = new int[4];

    /** Sensor values, [direction][input], in [-1, 1]. */
    public final double[][] sensors;

    /** Activations of the nodes behind the inputs, [direction][node], in [-1, 1]. */
    public final double[][] activations;

    /** Makes room for the values of a network. */
    public ReplayStep(ReplayNetwork network) {
        sensors = new double[4][network.inputs().size()];
        activations = new double[4][network.nodes().size()];
    }
}
