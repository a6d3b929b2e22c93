package mmneat.mspacman.sensors;

import java.util.Arrays;
import pacman.game.Game;
import pacman.maze.ApproachTables;
import pacman.maze.MazePaths;
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

    /** Distance minus 1, in a sort key, of a ghost that has no distance. */
    private static final int FARTHEST = (1 << 28) - 1;

    @SuppressWarnings("NullAway.Init")
    private Game game;

    @SuppressWarnings("NullAway.Init")
    private SensorTables tables;

    @SuppressWarnings("NullAway.Init")
    private MazePaths paths;

    @SuppressWarnings("NullAway.Init")
    private Routes routes;

    // The state.
    private int mazeIndex;
    private int node;
    /** Open directions from her node, as bits. */
    private int open;

    private final int[] ghostNode = new int[GHOSTS];
    private final int[] edibleTime = new int[GHOSTS];
    private final int[] lairTime = new int[GHOSTS];
    private final PillsLeft pills = new PillsLeft();
    private final PillsLeft powerPills = new PillsLeft();

    // Values that are computed from the state.
    private final long[] ghostRoute = new long[GHOSTS];
    private final int[] ghostPlace = new int[GHOSTS];
    private final int[] ghostPathLength = new int[GHOSTS];
    /** Per ghost, the number of steps in which it cannot stop her. */
    private final int[] harmless = new int[GHOSTS];

    private final int[] neighboursPassed = new int[GHOSTS];

    /** Whether each ghost heads for her; valid if its bit is set in {@link #headingKnown}, and computed on request. */
    private final boolean[] heading = new boolean[GHOSTS];

    private int headingKnown;
    private int highestEdibleTime;
    private int edibleGhosts;
    private int threats;
    private int harmlessSteps;

    // Values that are computed from the direction.
    private int direction;
    private long route;
    private int least;
    private final int[] ghostDistance = new int[GHOSTS];

    /**
     * Steps to each ghost that is in the corridor ahead, 0 for one on her node in a straight corridor; else below 0.
     */
    private final int[] stepsAhead = new int[GHOSTS];

    /** Distance and number of each ghost outside the lair, nearest first. */
    private final int[] orderKeys = new int[GHOSTS];

    private int ghostsOutside;

    /** Per direction, the list of walks for which {@link #mostPills} was found, -1 if pills have changed since. */
    private final int[] knownWalks = new int[4];

    private final int[] mostPills = new int[4];

    private final SafetyTest safety = new SafetyTest(this);

    // ---- Taking in the state ----

    /** Takes in the state of a game. */
    void observe(Game observed, SensorTables maze) {
        game = observed;
        enter(maze, observed.getMazeIndex());
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
    }

    /** Sets the maze; pills are given afterwards. */
    void enter(SensorTables maze, int index) {
        mazeIndex = index;
        if (tables == maze) {
            return;
        }
        tables = maze;
        paths = maze.paths;
        routes = maze.routes;
        pills.enter(maze.pills, routes.rowCount(), maze.graph.pillWords());
        powerPills.enter(maze.powerPills, routes.rowCount(), 1);
        Arrays.fill(knownWalks, -1);
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
        ghostNode[ghost] = atNode;
        edibleTime[ghost] = edible;
        lairTime[ghost] = lair;
        ghostRoute[ghost] = lair > 0 ? 0 : routes.continuing(atNode, lastMove);
    }

    /** Computes the values that depend only on the state; call it when the whole state is set. */
    void conclude() {
        headingKnown = 0;
        highestEdibleTime = 0;
        edibleGhosts = 0;
        threats = 0;
        harmlessSteps = Integer.MAX_VALUE;
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            highestEdibleTime = Math.max(highestEdibleTime, edibleTime[ghost]);
            if (edibleTime[ghost] > 0) {
                edibleGhosts++;
            } else if (ghostNode[ghost] != tables.graph.lair()) {
                threats++;
            }
            if (isOutside(ghost)) {
                int approach = tables.approaches.approach(ghostRoute[ghost], node);
                ghostPathLength[ghost] = ApproachTables.lengthOf(approach);
                neighboursPassed[ghost] = ApproachTables.neighboursOf(approach);
                ghostPlace[ghost] = routes.place(ghostNode[ghost]);
            }
            harmless[ghost] = safety.harmlessSteps(ghost);
            harmlessSteps = Math.min(harmlessSteps, harmless[ghost]);
        }
    }

    /** Sets the direction, which must be open, for all later queries that depend on a direction. */
    public void face(int newDirection) {
        direction = newDirection;
        route = routes.leaving(node, newDirection);
        int sideways = 0b1010 >> (newDirection & 1) & 0b1111;
        least = (open & sideways) == 0 ? 0 : 1;
        ghostsOutside = 0;
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            orderKeys[ghost] = Integer.MAX_VALUE;
            if (isOutside(ghost)) {
                int place = ghostPlace[ghost];
                int ahead = Routes.aheadOfPlace(route, place);
                int distance =
                        ahead >= least ? ahead : Routes.steps(route) + paths.lengthToPlace(Routes.row(route), place);
                stepsAhead[ghost] = ahead;
                ghostDistance[ghost] = distance;
                orderKeys[ghost] = (distance - 1 & FARTHEST) << 2 | ghost;
                ghostsOutside++;
            }
        }
        order();
    }

    /*
     * By distance, where no distance counts as larger than any; ghosts at the same distance in the order of their
     * numbers, those in the lair last. Five comparisons sort four keys; as minimum and maximum they need no branches,
     * which the processor could not predict.
     */
    private void order() {
        int a = Math.min(orderKeys[0], orderKeys[1]);
        int b = Math.max(orderKeys[0], orderKeys[1]);
        int c = Math.min(orderKeys[2], orderKeys[3]);
        int d = Math.max(orderKeys[2], orderKeys[3]);
        int inner = Math.max(a, c);
        int other = Math.min(b, d);
        orderKeys[0] = Math.min(a, c);
        orderKeys[1] = Math.min(inner, other);
        orderKeys[2] = Math.max(inner, other);
        orderKeys[3] = Math.max(b, d);
    }

    // ---- For the safety test ----

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

    /** The route of a ghost outside the lair, as {@link Routes} encodes it. */
    long ghostRoute(int ghost) {
        return ghostRoute[ghost];
    }

    /** Place of a ghost outside the lair, as {@link Routes#place} numbers it. */
    int ghostPlace(int ghost) {
        return ghostPlace[ghost];
    }

    /** Steps to a ghost outside the lair if it is in the corridor before the next junction; else 0 or less. */
    int stepsAhead(int ghost) {
        return stepsAhead[ghost];
    }

    /** Number of steps in which no ghost can stop Ms. Pac-Man, wherever she goes; below 0 if there is a threat. */
    int harmlessSteps() {
        return harmlessSteps;
    }

    /** The same for one ghost. */
    int harmlessSteps(int ghost) {
        return harmless[ghost];
    }

    /**
     * Whether a ghost outside the lair takes the shortest path to Ms. Pac-Man; both lengths as the simulator has them.
     */
    boolean headsForPacMan(int ghost) {
        if ((headingKnown >> ghost & 1) == 0) {
            headingKnown |= 1 << ghost;
            heading[ghost] = ghostPathLength[ghost] == paths.undirectedLength(ghostNode[ghost], node);
        }
        return heading[ghost];
    }

    /** Steps of a ghost's own path to Ms. Pac-Man. */
    int ghostPathLength(int ghost) {
        return ghostPathLength[ghost];
    }

    /** One word of the bits of active pills. */
    long activePills(int word) {
        return pills.bits()[word];
    }

    /**
     * One number for everything that the published non-directional sensors depend on: highest edible time, whether a
     * power pill is close, and the numbers of edible ghosts, threats, power pills and pills.
     */
    long commonState() {
        return (long) highestEdibleTime << 32
                | (isCloseToPowerPill() ? 1L << 31 : 0)
                | (long) (edibleGhosts << 28 | threats << 24 | powerPills.count() << 16 | pills.count());
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
        return ghostNode[ghost];
    }

    /** Steps for which a ghost stays edible; 0 if it is not. */
    public int edibleTime(int ghost) {
        return edibleTime[ghost];
    }

    /** Steps for which a ghost stays in the lair; 0 outside. */
    public int lairTime(int ghost) {
        return lairTime[ghost];
    }

    /** Whether Ms. Pac-Man can eat a ghost. */
    public boolean isEdible(int ghost) {
        return edibleTime[ghost] > 0;
    }

    /** Whether a ghost is neither edible nor on the lair's node. */
    public boolean isThreat(int ghost) {
        return edibleTime[ghost] == 0 && ghostNode[ghost] != tables.graph.lair();
    }

    /** Whether a ghost is not in the lair. */
    public boolean isOutside(int ghost) {
        return lairTime[ghost] == 0;
    }

    /** Number of edible ghosts. */
    public int edibleGhosts() {
        return edibleGhosts;
    }

    /** Number of threats. */
    public int threats() {
        return threats;
    }

    /** Longest edible time of any ghost, 0 if none is edible. */
    public int highestEdibleTime() {
        return highestEdibleTime;
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
            int length = paths.length(route, least, tables.graph.junctionNode(j));
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
        return n < ghostsOutside ? orderKeys[n] & 3 : -1;
    }

    /**
     * The ghost of a kind outside the lair that is nth nearest in this direction among its kind.
     *
     * @param n from 0
     * @return its number, or -1 if there are no more than n
     */
    int nthNearestGhost(int n, GhostKind kind) {
        boolean edible = kind == GhostKind.EDIBLE;
        int left = n;
        for (int position = 0; position < ghostsOutside; position++) {
            int ghost = orderKeys[position] & 3;
            if (isEdible(ghost) == edible && left-- == 0) {
                return ghost;
            }
        }
        return -1;
    }

    /** Steps in this direction to a ghost outside the lair. */
    public int distanceToGhost(int ghost) {
        return ghostDistance[ghost];
    }

    /** Whether a ghost outside the lair is on a path to Ms. Pac-Man that comes in from this direction. */
    public boolean isApproaching(int ghost) {
        return (neighboursPassed[ghost] >> direction & 1) != 0;
    }

    /**
     * What is so of a ghost outside the lair: bit 0 approaching, bit 1 trapped, bit 2 edible. By arithmetic: as
     * branches they could not be predicted.
     */
    int flags(int ghost) {
        return neighboursPassed[ghost] >> direction & 1
                | (least - 1 - stepsAhead[ghost]) >>> 30 & 2
                | -edibleTime[ghost] >>> 29 & 4;
    }

    /**
     * Whether no junction lies between Ms. Pac-Man and a ghost outside the lair in this direction, nor under the ghost.
     */
    public boolean isTrapped(int ghost) {
        return stepsAhead[ghost] >= least;
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
