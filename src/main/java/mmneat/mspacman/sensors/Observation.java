package mmneat.mspacman.sensors;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import pacman.game.Game;
import pacman.maze.MazeTables;
import pacman.maze.Routes;

/**
 * The state of a game in one time step as sensors see it, in one direction from Ms.&nbsp;Pac-Man.
 *
 * <p>A threat is a ghost that is neither edible nor in the lair. An active pill is one that has not been eaten.
 * Directions are numbered UP 0, RIGHT 1, DOWN 2, LEFT 3; ghosts Blinky 0, Pinky 1, Inky 2, Sue 3. Distances are in
 * steps, times in steps. All paths are the simulator's (docs/specification/simulator.md, sections 4.3 and 4.4). One
 * thread uses an observation.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 4.
 */
public final class Observation {

    /*
     * Values that depend only on the state are computed once per time step (observe), values that depend on the
     * direction once per direction (face). Sensors only combine them. Nothing is allocated after the first step in a
     * maze.
     */

    /** Number of ghosts. */
    public static final int GHOSTS = 4;

    @SuppressWarnings("NullAway.Init")
    private Game game;

    /** Steps of the walks that are looked at. */
    private final int lookAhead;

    /** Distance below which a power pill is close. */
    private final double closeness;

    private @Nullable MazeTables maze;

    @SuppressWarnings("NullAway.Init")
    private SensorTables tables;

    // The state.
    private int mazeIndex;
    private int node;
    /** Open directions from her node, as bits. */
    private int open;

    private final ObservedGhosts ghosts = new ObservedGhosts();
    private final PillsLeft pills = new PillsLeft();
    private final PillsLeft powerPills = new PillsLeft();

    // Values that are computed from the direction.
    private int direction;
    private long route;
    private int least;

    /** Per direction, the list of walks for which {@link #mostPills} was found, -1 if pills have changed since. */
    private final int[] knownWalks = new int[4];

    private final int[] mostPills = new int[4];

    private final SafetyTest safety = new SafetyTest(this, ghosts);

    /**
     * An observation of nothing yet; {@link #observe} gives it a game.
     *
     * @param settings say how far walks reach and when a power pill is close
     */
    public Observation(SensorSettings settings) {
        lookAhead = settings.smallStepSimDepth();
        closeness = settings.closePowerPillDistance();
    }

    // ---- Taking in the state ----

    /**
     * Takes in the state of a game.
     *
     * @return whether the maze is another one than before
     */
    public boolean observe(Game observed) {
        game = observed;
        boolean isAnotherMaze = enter(observed.mazeTables(), observed.getMazeIndex());
        placePacMan(observed.getPacmanCurrentNodeIndex());
        for (int word = 0; word < pills.bits().length; word++) {
            setPills(word, observed.pillBits(word));
        }
        setPowerPills(observed.powerPillBits());
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            placeGhost(
                    ghost,
                    observed.ghostNode(ghost),
                    observed.ghostEdibleTime(ghost),
                    observed.ghostLairTime(ghost),
                    observed.ghostLastMove(ghost));
        }
        conclude();
        return isAnotherMaze;
    }

    /**
     * Sets the maze; pills are given afterwards.
     *
     * @return whether it is another one than before
     */
    boolean enter(MazeTables newMaze, int index) {
        mazeIndex = index;
        if (maze == newMaze) {
            return false;
        }
        maze = newMaze;
        tables = SensorTables.of(newMaze, lookAhead, closeness);
        ghosts.enter(tables);
        pills.enter(tables.pills, tables.routes.rowCount(), tables.graph.pillWords());
        powerPills.enter(tables.powerPills, tables.routes.rowCount(), 1);
        Arrays.fill(knownWalks, -1);
        return true;
    }

    /** Sets Ms. Pac-Man's node. */
    void placePacMan(int pacManNode) {
        node = pacManNode;
        open = tables.graph.openDirections(pacManNode);
    }

    /**
     * Sets one word of the bits of active pills; all words are set before {@link #conclude}.
     *
     * @param word number of the word
     */
    void setPills(int word, long bits) {
        if (pills.set(word, bits)) {
            Arrays.fill(knownWalks, -1);
        }
    }

    /** Sets the bits of the active power pills. */
    void setPowerPills(long bits) {
        powerPills.set(0, bits);
    }

    /**
     * Sets a ghost.
     *
     * @param lastMove 0 to 3, or 4 for none
     */
    void placeGhost(int ghost, int atNode, int edible, int lair, int lastMove) {
        ghosts.place(ghost, atNode, edible, lair, lastMove);
    }

    /** Computes the values that depend only on the state; call it when the whole state is set. */
    void conclude() {
        ghosts.conclude(node);
        safety.conclude();
    }

    /** Sets the direction, which must be open, for all later queries that depend on a direction. */
    public void face(int newDirection) {
        direction = newDirection;
        route = tables.routes.leaving(node, newDirection);
        int sideways = 0b1010 >> (newDirection & 1) & 0b1111;
        least = (open & sideways) == 0 ? 0 : 1;
        ghosts.face(newDirection, route, least);
    }

    // ---- For classes of this package ----

    SensorTables tables() {
        return tables;
    }

    /** Ms. Pac-Man's route in the current direction, as {@link Routes} encodes it. */
    long route() {
        return route;
    }

    /** 0 if a target on her own node is reached by no step in this direction, 1 if only by a way around. */
    int least() {
        return least;
    }

    /** One word of the bits of active pills. */
    long activePills(int word) {
        return pills.bits()[word];
    }

    /**
     * One number for everything that the published non-directional sensors depend on: highest edible time, whether a
     * power pill is close, and the numbers of edible ghosts, threats, power pills and pills.
     */
    public long commonState() {
        return (long) ghosts.highestEdibleTime() << 32
                | (isCloseToPowerPill() ? 1L << 31 : 0)
                | (long) (ghosts.edibleCount() << 28
                        | ghosts.threats() << 24
                        | powerPills.count() << 16
                        | pills.count());
    }

    // ---- What sensors ask ----

    /** The game, for sensors that need more than the queries here: read it, do not change it. */
    public Game game() {
        return game;
    }

    /** The direction for which sensors are computed, 0 to 3. */
    public int direction() {
        return direction;
    }

    /** Index of the maze, from 0. */
    public int mazeIndex() {
        return mazeIndex;
    }

    /** Ms. Pac-Man's node. */
    public int pacManNode() {
        return node;
    }

    /** Whether a corridor leads from Ms. Pac-Man in a direction. */
    public boolean isOpen(int inDirection) {
        return (open >> inDirection & 1) != 0;
    }

    /** Whether Ms. Pac-Man is where three or more corridors meet. */
    public boolean isAtJunction() {
        return tables.graph.isJunction(node);
    }

    /** Node of a ghost; the lair's while it is there. */
    public int ghostNode(int ghost) {
        return ghosts.node(ghost);
    }

    /** Steps for which a ghost stays edible; 0 if it is not. */
    public int edibleTime(int ghost) {
        return ghosts.edibleTime(ghost);
    }

    /** Steps for which a ghost stays in the lair; 0 outside. */
    public int lairTime(int ghost) {
        return ghosts.lairTime(ghost);
    }

    /** Whether Ms. Pac-Man can eat a ghost. */
    public boolean isEdible(int ghost) {
        return ghosts.isEdible(ghost);
    }

    /** Whether a ghost is neither edible nor on the lair's node. */
    public boolean isThreat(int ghost) {
        return ghosts.isThreat(ghost);
    }

    /** Whether a ghost is not in the lair. */
    public boolean isOutside(int ghost) {
        return ghosts.isOutside(ghost);
    }

    /** Number of edible ghosts. */
    public int edibleGhosts() {
        return ghosts.edibleCount();
    }

    /** Number of threats. */
    public int threats() {
        return ghosts.threats();
    }

    /** Longest edible time of any ghost, 0 if none is edible. */
    public int highestEdibleTime() {
        return ghosts.highestEdibleTime();
    }

    /** Number of pills that are left. */
    public int pillsLeft() {
        return pills.count();
    }

    /** Number of pills of the maze, whether or not this game started with all of them. */
    public int pillsOfMaze() {
        return tables.graph.pillCount();
    }

    /** Number of power pills that are left. */
    public int powerPillsLeft() {
        return powerPills.count();
    }

    /** Number of power pills of the maze. */
    public int powerPillsOfMaze() {
        return tables.graph.powerPillCount();
    }

    /**
     * Whether a power pill that is not eaten is closer than {@link SensorSettings#closePowerPillDistance}, by shortest
     * distance.
     */
    public boolean isCloseToPowerPill() {
        return (tables.closePowerPills[node] & powerPills.bits()[0]) != 0;
    }

    /** Steps in this direction to the nearest active pill, or -1 if none is left. */
    public int nearestPill() {
        return pills.nearest(node, direction, route, least);
    }

    /** Steps in this direction to the nearest active power pill, or -1 if none is left. */
    public int nearestPowerPill() {
        return powerPills.nearest(node, direction, route, least);
    }

    /** Steps in this direction to the next junction. */
    public int nearestJunction() {
        return Routes.steps(route);
    }

    /**
     * Steps in this direction to the junction that is nth nearest in it, or -1 if there are no more than n.
     *
     * @param n from 0
     */
    public int nthNearestJunction(int n) {
        if (n >= tables.graph.junctionCount()) {
            return -1;
        }
        int found = -1;
        for (int rank = 0; rank <= n; rank++) {
            found = nextFartherJunction(found, rank);
        }
        return found;
    }

    /** Distance of the junction of a rank, given that of the rank before. */
    private int nextFartherJunction(int before, int rank) {
        int notFarther = 0;
        int next = Integer.MAX_VALUE;
        for (int j = 0; j < tables.graph.junctionCount(); j++) {
            int length = tables.paths.length(route, least, tables.graph.junctionNode(j));
            if (length <= before) {
                notFarther++;
            } else {
                next = Math.min(next, length);
            }
        }
        // Several junctions may be equally far.
        if (notFarther > rank) {
            return before;
        }
        return next;
    }

    /**
     * The ghost outside the lair that is nth nearest in this direction.
     *
     * @param n from 0
     * @return its number, or -1 if there are no more than n
     */
    public int nthNearestGhost(int n) {
        return ghosts.nthNearest(n);
    }

    /**
     * The nth nearest in this direction of the ghosts outside the lair that are not edible.
     *
     * @param n from 0
     * @return its number, or -1 if there are no more than n
     */
    public int nthNearestThreat(int n) {
        return ghosts.nthNearest(n, false);
    }

    /**
     * The nth nearest in this direction of the edible ghosts outside the lair.
     *
     * @param n from 0
     * @return its number, or -1 if there are no more than n
     */
    public int nthNearestEdibleGhost(int n) {
        return ghosts.nthNearest(n, true);
    }

    /** Steps in this direction to a ghost outside the lair. */
    public int distanceToGhost(int ghost) {
        return ghosts.distance(ghost);
    }

    /** Whether a ghost outside the lair is on a path to Ms. Pac-Man that comes in from this direction. */
    public boolean isApproaching(int ghost) {
        return ghosts.isApproaching(ghost);
    }

    /**
     * Whether no junction lies between Ms. Pac-Man and a ghost outside the lair in this direction, nor under the ghost.
     */
    public boolean isTrapped(int ghost) {
        return ghosts.isTrapped(ghost);
    }

    /** Facts about a ghost outside the lair in this direction: bit 0 approaching, bit 1 trapped, bit 2 edible. */
    public int ghostFlags(int ghost) {
        return ghosts.flags(ghost);
    }

    /** Most active pills on a walk of the look-ahead depth in this direction that never turns back. */
    public int mostPillsAhead() {
        int list = tables.walks.list(node, direction);
        if (list != knownWalks[direction]) {
            knownWalks[direction] = list;
            mostPills[direction] = tables.walks.mostPills(list, pills.bits());
        }
        return mostPills[direction];
    }

    /** Most junctions on a walk of the look-ahead depth in this direction that never turns back. */
    public int mostJunctionsAhead() {
        return tables.walks.mostJunctions(node, direction);
    }

    /**
     * Number of safe moves at the next junction in this direction. A move is safe if Ms. Pac-Man can follow it to the
     * junction after that one before any ghost stops her; the move back does not count. 0 if she cannot even reach the
     * next junction safely. The rules of the test are in docs/specification/mspacman-task.md, section 4.11.
     */
    public int safeOptionsAfterJunction() {
        return safety.options();
    }
}
