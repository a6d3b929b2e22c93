package pacman.game;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Objects;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.GameRules.Conventions;
import pacman.game.GameStep.Reversal;
import pacman.game.internal.Maze;
import pacman.game.internal.PathsCache;
import pacman.maze.MazePoses;
import pacman.maze.MazeTables;

/**
 * A game of Ms.&nbsp;Pac-Man vs Ghosts: the competition's interface on top of the engine.
 *
 * <p>Usually a loop calls both controllers, each with its own {@link #copy()}, and passes the answers to {@link
 * #advanceGame}, until {@link #gameOver()}. Times are in game steps, path distances in nodes, other distances in
 * pixels. A node is its index in the maze's graph; a pill or power pill "number" is its position in the list of the
 * maze, not a node. Node arguments outside the maze throw {@link IndexOutOfBoundsException}. Arrays of the maze that
 * queries return (moves, neighbours, junctions, pills) are shared: do not modify them.
 *
 * <p>A game is used by one thread at a time. Different games share no mutable state, except a generator that is passed
 * to several.
 *
 * <p>Source: docs/specification/simulator.md, section 6.
 */
public final class Game {

    private static final MOVE[] MOVES = MOVE.values();
    private static final GHOST[] GHOSTS = GHOST.values();
    /** Completed calls after which a null move of Ms. Pac-Man ends the game. */
    private static final int CALLS_BEFORE_NULL_COUNTS = 10;

    /**
     * The paths of the four mazes, for entries of the competition. The array is not final because that interface
     * declares it so; the simulator never reads it. Source: docs/specification/simulator.md, section 1.4.
     */
    public static PathsCache[] caches = {new PathsCache(0), new PathsCache(1), new PathsCache(2), new PathsCache(3)};

    /**
     * The game's own generator. If copies continue the game ({@link GameRules.Copies#CONTINUE_THE_GAME}), the generator
     * of a copy returns the numbers that the game itself will draw next.
     */
    public final ResumableRandom rnd;

    private final GameState state;

    /** Creates a competition game in the first maze. */
    public Game(long seed) {
        this(seed, 0);
    }

    /**
     * Creates a competition game that starts in one of the four mazes.
     *
     * @throws IllegalArgumentException if there is no such maze
     */
    public Game(long seed, int initialMaze) {
        this(seed, initialMaze == 0 ? CompetitionRules.RULES : CompetitionRules.from(initialMaze));
    }

    /** Creates a game by given rules. The seed determines all its random numbers. */
    public Game(long seed, GameRules rules) {
        this(seed, rules, null);
    }

    /**
     * Creates a game by given rules that is part of an evolution run, in which all games share one generator.
     *
     * @param shared the generator of the run. As in MM-NEAT, the random numbers of the task come from it: locations of
     *     ghosts that leave the lair, missing pills, and a number whenever a ghost's edible time ends. Copies under
     *     {@link GameRules.Copies#CONTINUE_THE_GAME} also draw from it. If null, the game's own generator is used
     */
    public Game(long seed, GameRules rules, @Nullable ResumableRandom shared) {
        this(new GameState(seed, rules, shared));
    }

    private Game(GameState state) {
        this.state = state;
        rnd = state.random;
    }

    /** The default rules, in a separate class so that they exist before {@link #caches} creates games. */
    private static final class CompetitionRules {
        static final GameRules RULES = GameRules.competition();

        static GameRules from(int maze) {
            return RULES.withMazes(mazes -> mazes.withInitialMaze(maze));
        }
    }

    // ---- Copying and starting again

    /**
     * Returns a game in the same state. The rules determine its random numbers: {@link GameRules.Copies}.
     *
     * <p>By the competition's conventions the copy is complete. By MM-NEAT's conventions some of the state is missing
     * in it, as in MM-NEAT. The queries about the last step ({@link #wasPillEaten} and others) return false. The lists
     * of times and scores are absent. These switches are off: {@link GameSwitch#EXIT_LAIR_EDIBLE}, {@link
     * GameSwitch#END_ONLY_ON_TIME_LIMIT}, {@link GameSwitch#RANDOM_LAIR_EXIT}, {@link GameSwitch#LAIR_EXIT_DATABASE},
     * {@link GameSwitch#SIMULTANEOUS_LAIR_EXIT} and {@link GameSwitch#REMOVE_PILLS_NEAR_POWER_PILLS}. A controller that
     * advances its copy of an isolated ghost game therefore simulates other rules than the game has.
     */
    public Game copy() {
        return new Game(state.copy());
    }

    /**
     * Sets a generator to the state that the generator of the next {@link #copy()} would have, without making the copy.
     * Independent copies are numbered, and the number determines the random numbers; this call uses up one number as
     * {@code copy()} does. A controller that only reads this game and draws from {@code scratch} then gives the same
     * answer as with the copy.
     */
    public void continueAsCopy(ResumableRandom scratch) {
        state.continueAsCopy(scratch);
    }

    /** Returns a copy for a view. It does not count as a copy, so that showing a game does not change it. */
    Game snapshot() {
        return new Game(state.snapshot());
    }

    /**
     * Starts a new game by the same rules in this object, without allocation. Switches are reset to those of the rules.
     */
    public void restart(long seed) {
        state.restart(seed);
    }

    /** The rules of the game, without switches that were set later. */
    public GameRules rules() {
        return state.rules;
    }

    /**
     * Returns the state as a string of comma-separated fields: 35 by the competition's conventions, 56 by MM-NEAT's.
     */
    public String getGameState() {
        return StateText.write(state);
    }

    /**
     * Restores a state string of either conventions. Everything that the string does not contain stays unchanged.
     *
     * @throws IllegalArgumentException if the string is not a state of a game in these mazes; the game is then
     *     unchanged
     */
    public void setGameState(String gameState) {
        StateText.read(state, gameState);
    }

    // ---- Advancing

    /**
     * Plays one step.
     *
     * @param pacManMove requested direction. If it is not open, NEUTRAL or null, she goes straight on; if that way is
     *     closed, she stops. By MM-NEAT's conventions null ends the game if this object has made more than 10 steps
     *     before the last one, that is, from the twelfth call on; before that, null is an ordinary closed direction
     * @param ghostMoves requested directions; may be null or incomplete; afterwards it contains the moves made. A ghost
     *     whose request is missing, closed or back goes straight on; if that way is closed, it takes a random open
     *     direction that is not back
     */
    public void advanceGame(@Nullable MOVE pacManMove, @Nullable EnumMap<GHOST, MOVE> ghostMoves) {
        if (endsByNull(pacManMove)) {
            return;
        }
        updatePacMan(pacManMove);
        updateGhosts(ghostMoves);
        updateGame();
        state.calls++;
    }

    /**
     * Plays one step like {@link #advanceGame(MOVE, EnumMap)}, without a map.
     *
     * @param ghostMoves requested directions, encoded as {@link GhostMoves}
     */
    public void advanceGame(@Nullable MOVE pacManMove, int ghostMoves) {
        if (endsByNull(pacManMove)) {
            return;
        }
        updatePacMan(pacManMove);
        GameStep.updateGhosts(state, ghostMoves, Reversal.NORMAL);
        updateGame();
        state.calls++;
    }

    private boolean endsByNull(@Nullable MOVE pacManMove) {
        if (pacManMove == null
                && state.calls > CALLS_BEFORE_NULL_COUNTS
                && state.rules.conventions() == Conventions.MM_NEAT) {
            state.gameOver = true;
            return true;
        }
        return false;
    }

    /** Plays one step in which no ghost reverses. */
    public void advanceGameWithoutReverse(MOVE pacManMove, EnumMap<GHOST, MOVE> ghostMoves) {
        updatePacMan(pacManMove);
        updateGhostsWithoutReverse(ghostMoves);
        updateGame();
    }

    /** Plays one step in which all ghosts reverse. */
    public void advanceGameWithForcedReverse(MOVE pacManMove, EnumMap<GHOST, MOVE> ghostMoves) {
        updatePacMan(pacManMove);
        updateGhostsWithForcedReverse(ghostMoves);
        updateGame();
    }

    /** Plays one step in which ghosts reverse only if a power pill is eaten. */
    public void advanceGameWithPowerPillReverseOnly(MOVE pacManMove, EnumMap<GHOST, MOVE> ghostMoves) {
        updatePacMan(pacManMove);
        if (state.powerPillEaten) {
            updateGhostsWithForcedReverse(ghostMoves);
        } else {
            updateGhostsWithoutReverse(ghostMoves);
        }
        updateGame();
    }

    /**
     * Ms.&nbsp;Pac-Man's part of a step: she moves and eats a pill on her node.
     *
     * <p>{@link #advanceGame(MOVE, EnumMap)} makes the three parts of a step in this order: {@code updatePacMan},
     * {@code updateGhosts}, {@code updateGame}. They are for controllers that simulate parts of a step in their copy;
     * all others call {@code advanceGame}.
     */
    public void updatePacMan(@Nullable MOVE pacManMove) {
        GameStep.updatePacMan(state, GhostMoves.request(pacManMove));
    }

    /** The ghosts' part of a step: they move, or reverse at random or after a power pill. */
    public void updateGhosts(@Nullable EnumMap<GHOST, MOVE> ghostMoves) {
        updateGhosts(ghostMoves, Reversal.NORMAL);
    }

    /** The ghosts' part of a step, in which they never reverse. */
    public void updateGhostsWithoutReverse(EnumMap<GHOST, MOVE> ghostMoves) {
        updateGhosts(ghostMoves, Reversal.NEVER);
    }

    /** The ghosts' part of a step, in which they reverse instead of moving as requested. */
    public void updateGhostsWithForcedReverse(EnumMap<GHOST, MOVE> ghostMoves) {
        updateGhosts(ghostMoves, Reversal.FORCED);
    }

    private void updateGhosts(@Nullable EnumMap<GHOST, MOVE> moves, Reversal reversal) {
        if (moves == null) {
            GameStep.updateGhosts(state, GhostMoves.NONE, reversal);
            return;
        }
        MOVE blinky = moves.get(GHOST.BLINKY);
        MOVE pinky = moves.get(GHOST.PINKY);
        MOVE inky = moves.get(GHOST.INKY);
        MOVE sue = moves.get(GHOST.SUE);
        boolean isComplete = moves.size() == GHOSTS.length;
        int moved = GameStep.updateGhosts(state, GhostMoves.packed(blinky, pinky, inky, sue), reversal);
        report(moves, GHOST.BLINKY, blinky, moved, isComplete);
        report(moves, GHOST.PINKY, pinky, moved, isComplete);
        report(moves, GHOST.INKY, inky, moved, isComplete);
        report(moves, GHOST.SUE, sue, moved, isComplete);
    }

    /** Writes the move that a ghost made into the caller's map, or NEUTRAL if the caller gave no move for it. */
    private void report(
            EnumMap<GHOST, MOVE> moves, GHOST ghost, @Nullable MOVE requested, int moved, boolean isComplete) {
        if ((moved >>> ghost.ordinal() & 1) != 0) {
            MOVE made = getGhostLastMoveMade(ghost);
            if (made != requested) {
                moves.put(ghost, made);
            }
        } else if (requested == null && !isComplete && !moves.containsKey(ghost)) {
            moves.put(ghost, MOVE.NEUTRAL);
        }
    }

    /**
     * The part of a step after the moves: meetings of ghosts and Ms.&nbsp;Pac-Man, lair times, clocks, the end of level
     * and game.
     */
    public void updateGame() {
        updateGame(true, true, true, true, true);
    }

    /**
     * Selected parts of {@link #updateGame()}, in the order of the parameters. The end of level and game is always
     * checked.
     *
     * @param feast whether Ms.&nbsp;Pac-Man and ghosts that meet eat each other, and edible times run
     * @param updateLairTimes whether lair times run and ghosts leave the lair
     * @param updateExtraLife whether the extra life is given when its score is reached
     * @param updateTotalTime whether the clock of the game advances
     * @param updateLevelTime whether the clock of the level advances
     */
    public void updateGame(
            boolean feast,
            boolean updateLairTimes,
            boolean updateExtraLife,
            boolean updateTotalTime,
            boolean updateLevelTime) {
        if (feast) {
            GameStep.updateMeetings(state);
        }
        if (updateLairTimes) {
            LairExits.update(state);
        }
        if (updateExtraLife) {
            GameStep.updateExtraLife(state);
        }
        if (updateTotalTime) {
            state.totalTime++;
        }
        if (updateLevelTime) {
            state.levelTime++;
        }
        GameStep.endLevelOrGame(state);
    }

    // ---- What happened in the last step

    public boolean wasPacManEaten() {
        return state.pacManEaten;
    }

    public boolean wasGhostEaten(GHOST ghost) {
        return (state.ghostsEaten >>> ghost.ordinal() & 1) != 0;
    }

    /** Ghosts eaten in the last step, 0 to 4. */
    public int getNumGhostsEaten() {
        return Integer.bitCount(state.ghostsEaten);
    }

    public boolean wasPillEaten() {
        return state.pillEaten;
    }

    public boolean wasPowerPillEaten() {
        return state.powerPillEaten;
    }

    /**
     * Total time before the step in which ghosts last reversed, after a power pill or at random; -1 if they never did.
     */
    public int getTimeOfLastGlobalReversal() {
        return state.timeOfLastReversal;
    }

    public boolean gameOver() {
        return state.gameOver;
    }

    // ---- Level, score, time

    public int getScore() {
        return state.score;
    }

    /** Completed steps in this level. */
    public int getCurrentLevelTime() {
        return state.levelTime;
    }

    /** Completed steps in this game. */
    public int getTotalTime() {
        return state.totalTime;
    }

    /** Level from 0, counted across the mazes. */
    public int getCurrentLevel() {
        return state.level;
    }

    public int getMazeIndex() {
        return state.mazeIndex;
    }

    /**
     * Steps until the level time limit. It is negative if the rules leave the end of the game to the controller ({@link
     * LevelRules#fatalTimeLimit}) and the controller plays on.
     */
    public int levelTimeLeft() {
        return state.rules.levels().levelTimeLimit() - state.levelTime;
    }

    /** Points for the next ghost. */
    public int getGhostCurrentEdibleScore() {
        return Constants.GHOST_EAT_SCORE * state.ghostMultiplier;
    }

    // ---- Ms. Pac-Man

    public int getPacmanCurrentNodeIndex() {
        return state.pacManNode();
    }

    /** Ms. Pac-Man's last move; NEUTRAL if she did not move, LEFT at the start of a level. */
    public MOVE getPacmanLastMoveMade() {
        return MOVES[pacManLastMove()];
    }

    /** Lives, including the current one. */
    public int getPacmanNumberOfLivesRemaining() {
        return state.lives;
    }

    // ---- Ghosts

    /** Node of a ghost; the lair node while it is in the lair. */
    public int getGhostCurrentNodeIndex(GHOST ghost) {
        return state.ghostNode(ghost.ordinal());
    }

    /** Last move of a ghost; NEUTRAL until it moves after the lair. */
    public MOVE getGhostLastMoveMade(GHOST ghost) {
        return MOVES[state.ghostMove(ghost.ordinal())];
    }

    /** Steps for which a ghost stays edible; 0 if it is not. */
    public int getGhostEdibleTime(GHOST ghost) {
        return state.ghosts[GameState.EDIBLE + ghost.ordinal()];
    }

    public boolean isGhostEdible(GHOST ghost) {
        return getGhostEdibleTime(ghost) > 0;
    }

    /** Steps for which a ghost stays in the lair; 0 outside. */
    public int getGhostLairTime(GHOST ghost) {
        return state.ghosts[GameState.LAIR + ghost.ordinal()];
    }

    /**
     * Whether a ghost may choose a direction: it is at a junction or just left the lair, and moves in the next step.
     */
    public boolean doesGhostRequireAction(GHOST ghost) {
        return state.requiresAction(ghost.ordinal());
    }

    /** Bit set of the ghosts for which {@link #doesGhostRequireAction} is true; BLINKY has the lowest bit. */
    public int ghostsRequiringAction() {
        int ghosts = 0;
        for (int ghost = 0; ghost < GHOSTS.length; ghost++) {
            if (state.requiresAction(ghost)) {
                ghosts |= 1 << ghost;
            }
        }
        return ghosts;
    }

    /**
     * Whether a ghost is a threat: neither edible nor in the lair.
     *
     * @param ghostIndex 0 to 3
     * @throws IndexOutOfBoundsException if there is no such ghost
     */
    public boolean isGhostThreat(int ghostIndex) {
        return state.isThreat(requireGhost(ghostIndex));
    }

    /** Nodes of the threats, in ghost order. */
    public int[] getThreatGhostLocations() {
        int[] nodes = new int[GHOSTS.length];
        int count = 0;
        for (int ghost = 0; ghost < GHOSTS.length; ghost++) {
            if (state.isThreat(ghost)) {
                nodes[count++] = state.ghostNode(ghost);
            }
        }
        return Arrays.copyOf(nodes, count);
    }

    public int getNumEdibleGhosts() {
        return state.edibleGhosts();
    }

    /** Steps for which a power pill makes ghosts edible in this level. */
    public int newEdibleTime() {
        return state.newEdibleTime();
    }

    // ---- Pills

    /** Whether a pill is present; false for a number that the maze does not have. */
    public boolean isPillStillAvailable(int pillIndex) {
        return isNumber("pill", pillIndex, state.graph.pillCount()) && state.hasPill(pillIndex);
    }

    /** Whether a power pill is present; false for a number that the maze does not have. */
    public boolean isPowerPillStillAvailable(int powerPillIndex) {
        return isNumber("power pill", powerPillIndex, state.graph.powerPillCount())
                && (state.powerPills >>> powerPillIndex & 1) != 0;
    }

    private static boolean isNumber(String kind, int number, int count) {
        if (number < 0) {
            throw new IndexOutOfBoundsException(kind + " number " + number + " is negative");
        }
        return number < count;
    }

    /** Number of the pill on a node, eaten or not; -1 if there is none. */
    public int getPillIndex(int nodeIndex) {
        return state.graph.pillNumber(nodeIndex);
    }

    /** Number of the power pill on a node, eaten or not; -1 if there is none. */
    public int getPowerPillIndex(int nodeIndex) {
        return state.graph.powerPillNumber(nodeIndex);
    }

    /** Nodes of the maze's pills, eaten or not. */
    public int[] getPillIndices() {
        return getCurrentMaze().pillIndices;
    }

    /** Nodes of the maze's power pills, eaten or not. */
    public int[] getPowerPillIndices() {
        return getCurrentMaze().powerPillIndices;
    }

    /** Nodes of the pills that are present, in number order. */
    public int[] getActivePillsIndices() {
        int[] nodes = new int[state.pillsLeft];
        int count = 0;
        for (int word = 0; word < state.pills.length; word++) {
            for (long bits = state.pills[word]; bits != 0; bits &= bits - 1) {
                int pill = 64 * word + Long.numberOfTrailingZeros(bits);
                // After the last level the maze is already the next one, but the pills are those of the last.
                if (pill < state.graph.pillCount()) {
                    nodes[count++] = state.graph.pillNode(pill);
                }
            }
        }
        return count == nodes.length ? nodes : Arrays.copyOf(nodes, count);
    }

    /** Nodes of the power pills that are present, in number order. */
    public int[] getActivePowerPillsIndices() {
        int[] nodes = new int[Long.bitCount(state.powerPills)];
        int count = 0;
        for (long bits = state.powerPills; bits != 0; bits &= bits - 1) {
            int powerPill = Long.numberOfTrailingZeros(bits);
            // As for pills.
            if (powerPill < state.graph.powerPillCount()) {
                nodes[count++] = state.graph.powerPillNode(powerPill);
            }
        }
        return count == nodes.length ? nodes : Arrays.copyOf(nodes, count);
    }

    /** Number of the maze's pills, eaten or not. */
    public int getNumberOfPills() {
        return state.graph.pillCount();
    }

    /** Number of the maze's power pills, eaten or not. */
    public int getNumberOfPowerPills() {
        return state.graph.powerPillCount();
    }

    public int getNumberOfActivePills() {
        return state.pillsLeft;
    }

    public int getNumberOfActivePowerPills() {
        return Long.bitCount(state.powerPills);
    }

    // ---- Maze

    /** The maze in the competition's interface; shared, do not modify. */
    public Maze getCurrentMaze() {
        return Maze.of(state.tables);
    }

    /**
     * Index of the maze of Ms. Pac-Man and the ghosts. After the last level {@link #getMazeIndex} is already that of
     * the next maze, in which their nodes are meaningless.
     */
    int shownMazeIndex() {
        return state.shownMazeIndex();
    }

    /** The maze of {@link #shownMazeIndex}. */
    Maze shownMaze() {
        return Maze.of(state.rules.mazes().mazes().get(shownMazeIndex()));
    }

    /** The tables of the maze that the engine uses: graph, distances and paths in primitive arrays. */
    public MazeTables mazeTables() {
        return state.tables;
    }

    /** Horizontal position of a node in pixels. */
    public int getNodeXCood(int nodeIndex) {
        return state.graph.x(nodeIndex);
    }

    /** Vertical position of a node in pixels, growing downwards. */
    public int getNodeYCood(int nodeIndex) {
        return state.graph.y(nodeIndex);
    }

    /** {@link #getNodeXCood}, in MM-NEAT's spelling. */
    public int getNodeXCoord(int nodeIndex) {
        return getNodeXCood(nodeIndex);
    }

    /** {@link #getNodeYCood}, in MM-NEAT's spelling. */
    public int getNodeYCoord(int nodeIndex) {
        return getNodeYCood(nodeIndex);
    }

    /** Number of nodes, the lair included. */
    public int getNumberOfNodes() {
        return state.graph.nodeCount();
    }

    /** Node on which ghosts leave the lair. */
    public int getGhostInitialNodeIndex() {
        return state.graph.ghostStart();
    }

    /** Nodes with three or more neighbours. */
    public int[] getJunctionIndices() {
        return getCurrentMaze().junctionIndices;
    }

    public boolean isJunction(int nodeIndex) {
        return state.graph.isJunction(nodeIndex);
    }

    /** Open directions of a node, in the order up, right, down, left; empty for the lair. */
    public MOVE[] getPossibleMoves(int nodeIndex) {
        return Objects.requireNonNull(moves().moves(nodeIndex, MOVE.NEUTRAL));
    }

    /** Open directions except back; all for NEUTRAL; null if the node cannot be entered by that move. */
    public MOVE @Nullable [] getPossibleMoves(int nodeIndex, MOVE lastMoveMade) {
        return moves().moves(nodeIndex, lastMoveMade);
    }

    /** Neighbours in the order up, right, down, left; empty for the lair. */
    public int[] getNeighbouringNodes(int nodeIndex) {
        return Objects.requireNonNull(moves().neighbours(nodeIndex, MOVE.NEUTRAL));
    }

    /** Neighbours except the one behind; all for NEUTRAL; null if the node cannot be entered by that move. */
    public int @Nullable [] getNeighbouringNodes(int nodeIndex, MOVE lastMoveMade) {
        return moves().neighbours(nodeIndex, lastMoveMade);
    }

    private NodeMoves moves() {
        return NodeMoves.of(state.tables);
    }

    /** The node in a direction; -1 if there is none, also for NEUTRAL and null. */
    public int getNeighbour(int nodeIndex, @Nullable MOVE moveToBeMade) {
        return moveToBeMade == null || moveToBeMade == MOVE.NEUTRAL
                ? -1
                : state.graph.neighbour(nodeIndex, moveToBeMade.ordinal());
    }

    /** The direction from a node to a neighbour; null if the nodes are not neighbours. */
    public @Nullable MOVE getMoveToMakeToReachDirectNeighbour(int currentNodeIndex, int neighbourNodeIndex) {
        for (int direction = 0; direction < 4; direction++) {
            int next = state.graph.neighbour(currentNodeIndex, direction);
            if (next >= 0 && next == neighbourNodeIndex) {
                return MOVES[direction];
            }
        }
        return null;
    }

    // ---- Distances and paths

    /** Path distance with turning back allowed; -1 to or from the lair. */
    public int getShortestPathDistance(int fromNodeIndex, int toNodeIndex) {
        return MoveQueries.pathDistance(state.tables, fromNodeIndex, toNodeIndex);
    }

    /** Length of {@link #getShortestPath(int, int, MOVE)}. */
    public int getShortestPathDistance(int fromNodeIndex, int toNodeIndex, MOVE lastMoveMade) {
        return MoveQueries.directedLength(
                state.tables, fromNodeIndex, toNodeIndex, lastMove(fromNodeIndex, toNodeIndex, lastMoveMade));
    }

    /** A path that may start in any direction: the nodes after the start, the target last. */
    public int[] getShortestPath(int fromNodeIndex, int toNodeIndex) {
        return state.tables.paths().undirectedPath(fromNodeIndex, toNodeIndex);
    }

    /** A path that does not turn back: the nodes after the start, the target last; not always the shortest. */
    public int[] getShortestPath(int fromNodeIndex, int toNodeIndex, MOVE lastMoveMade) {
        return state.tables
                .paths()
                .directedPath(fromNodeIndex, toNodeIndex, lastMove(fromNodeIndex, toNodeIndex, lastMoveMade));
    }

    /**
     * Checks the last move. Null is allowed where no reverse has to be forbidden: at a junction, in the lair, and if
     * both nodes are the same.
     */
    private int lastMove(int from, int to, MOVE lastMoveMade) {
        if (lastMoveMade == null && from != to && state.graph.degree(from) == 2) {
            throw new NullPointerException("a path that must not turn back needs the last move made");
        }
        return GhostMoves.request(lastMoveMade);
    }

    /**
     * The same as {@link #getShortestPath(int, int, MOVE)}.
     *
     * @deprecated a former name
     */
    @Deprecated
    public int[] getAStarPath(int fromNodeIndex, int toNodeIndex, MOVE lastMoveMade) {
        return getShortestPath(fromNodeIndex, toNodeIndex, lastMoveMade);
    }

    /**
     * The same as {@link #getShortestPath(int, int, MOVE)}.
     *
     * @deprecated a former name
     */
    @Deprecated
    public int[] getApproximateShortestPath(int fromNodeIndex, int toNodeIndex, MOVE lastMoveMade) {
        return getShortestPath(fromNodeIndex, toNodeIndex, lastMoveMade);
    }

    /**
     * The same as {@link #getShortestPathDistance(int, int, MOVE)}.
     *
     * @deprecated a former name
     */
    @Deprecated
    public int getApproximateShortestPathDistance(int fromNodeIndex, int toNodeIndex, MOVE lastMoveMade) {
        return getShortestPathDistance(fromNodeIndex, toNodeIndex, lastMoveMade);
    }

    /** Straight distance in pixels. */
    public double getEuclideanDistance(int fromNodeIndex, int toNodeIndex) {
        return MoveQueries.euclideanDistance(state.graph, fromNodeIndex, toNodeIndex);
    }

    /** Horizontal plus vertical distance in pixels. */
    public int getManhattanDistance(int fromNodeIndex, int toNodeIndex) {
        return MoveQueries.manhattanDistance(state.graph, fromNodeIndex, toNodeIndex);
    }

    public double getDistance(int fromNodeIndex, int toNodeIndex, DM distanceMeasure) {
        return MoveQueries.distance(state.tables, fromNodeIndex, toNodeIndex, distanceMeasure);
    }

    /** Distance without turning back; only {@link DM#PATH} uses the last move. */
    public double getDistance(int fromNodeIndex, int toNodeIndex, MOVE lastMoveMade, DM distanceMeasure) {
        return distanceMeasure == DM.PATH
                ? getShortestPathDistance(fromNodeIndex, toNodeIndex, lastMoveMade)
                : getDistance(fromNodeIndex, toNodeIndex, distanceMeasure);
    }

    /**
     * Returns the nearest of some nodes, at a tie the first; -1 if there are no nodes. By MM-NEAT's conventions entries
     * of -1 are skipped.
     */
    public int getClosestNodeIndexFromNodeIndex(int fromNodeIndex, int[] targetNodeIndices, DM distanceMeasure) {
        return MoveQueries.closest(
                state.tables, fromNodeIndex, targetNodeIndices, distanceMeasure, state.rules.conventions());
    }

    /** Returns the farthest of some nodes, at a tie the first; -1 if there are no nodes. */
    public int getFarthestNodeIndexFromNodeIndex(int fromNodeIndex, int[] targetNodeIndices, DM distanceMeasure) {
        return MoveQueries.farthest(state.tables, fromNodeIndex, targetNodeIndices, distanceMeasure);
    }

    /** The direction whose neighbour is nearest to a target; null in the lair. */
    public @Nullable MOVE getNextMoveTowardsTarget(int fromNodeIndex, int toNodeIndex, DM distanceMeasure) {
        return MoveQueries.nextMove(state.tables, fromNodeIndex, toNodeIndex, distanceMeasure, true);
    }

    /** The direction whose neighbour is farthest from a target; null in the lair. */
    public @Nullable MOVE getNextMoveAwayFromTarget(int fromNodeIndex, int toNodeIndex, DM distanceMeasure) {
        return MoveQueries.nextMove(state.tables, fromNodeIndex, toNodeIndex, distanceMeasure, false);
    }

    /**
     * The direction, other than back, whose neighbour is nearest to a target. The distance from the neighbour is that
     * of {@link #getDistance(int, int, DM)}, which allows turning back on the rest of the way.
     */
    public @Nullable MOVE getApproximateNextMoveTowardsTarget(
            int fromNodeIndex, int toNodeIndex, MOVE lastMoveMade, DM distanceMeasure) {
        return MoveQueries.nextMove(
                state.tables, fromNodeIndex, toNodeIndex, lastMoveMade.ordinal(), distanceMeasure, true);
    }

    /**
     * The direction, other than back, whose neighbour is farthest from a target. The distance from the neighbour is
     * that of {@link #getDistance(int, int, DM)}, which allows turning back on the rest of the way.
     */
    public @Nullable MOVE getApproximateNextMoveAwayFromTarget(
            int fromNodeIndex, int toNodeIndex, MOVE lastMoveMade, DM distanceMeasure) {
        return MoveQueries.nextMove(
                state.tables, fromNodeIndex, toNodeIndex, lastMoveMade.ordinal(), distanceMeasure, false);
    }

    /** The direction, other than back, from which the path that never turns back is shortest. */
    public @Nullable MOVE getNextMoveTowardsTarget(
            int fromNodeIndex, int toNodeIndex, MOVE lastMoveMade, DM distanceMeasure) {
        return nextMoveDirected(fromNodeIndex, toNodeIndex, lastMoveMade, distanceMeasure, true);
    }

    /** The direction, other than back, from which the path that never turns back is longest. */
    public @Nullable MOVE getNextMoveAwayFromTarget(
            int fromNodeIndex, int toNodeIndex, MOVE lastMoveMade, DM distanceMeasure) {
        return nextMoveDirected(fromNodeIndex, toNodeIndex, lastMoveMade, distanceMeasure, false);
    }

    private @Nullable MOVE nextMoveDirected(int from, int to, MOVE lastMoveMade, DM metric, boolean towards) {
        return MoveQueries.nextMoveDirected(
                state.tables, from, to, lastMoveMade.ordinal(), metric, towards, state.rules.conventions());
    }

    /*
     * State for sensors, by index and without allocation. A ghost's index is 0 to 3; another one throws an
     * IndexOutOfBoundsException.
     */

    private static int requireGhost(int ghost) {
        return Objects.checkIndex(ghost, GHOSTS.length);
    }

    /** Node of a ghost by index 0 to 3. */
    public int ghostNode(int ghost) {
        return state.ghostNode(requireGhost(ghost));
    }

    /** Edible time of a ghost by index. */
    public int ghostEdibleTime(int ghost) {
        return state.ghosts[GameState.EDIBLE + requireGhost(ghost)];
    }

    /** Lair time of a ghost by index. */
    public int ghostLairTime(int ghost) {
        return state.ghosts[GameState.LAIR + requireGhost(ghost)];
    }

    /** Last move of a ghost by index: 0 up, 1 right, 2 down, 3 left, 4 none. */
    public int ghostLastMove(int ghost) {
        return state.ghostMove(requireGhost(ghost));
    }

    /** Ms.&nbsp;Pac-Man's last move: 0 up, 1 right, 2 down, 3 left, 4 none. */
    public int pacManLastMove() {
        return MazePoses.move(state.pacManPose);
    }

    /** One word of the bit set of pills present, by pill number. */
    public long pillBits(int word) {
        return state.pills[word];
    }

    /** Bit set of power pills present, by power pill number. */
    public long powerPillBits() {
        return state.powerPills;
    }

    /**
     * Node of the nearest pill or power pill present, by path distance; of equally near ones pills before power pills,
     * then by number. -1 if there is none.
     */
    public int nearestPill(int node) {
        return state.tables.pillOrder().nearest(node, state.pills, state.pillsLeft, state.powerPills);
    }

    // ---- Switches of MM-NEAT's tasks; GameSwitch describes them

    public void setExitLairEdible(boolean on) {
        state.set(GameSwitch.EXIT_LAIR_EDIBLE, on);
    }

    public void setEndOnlyOnTimeLimit(boolean on) {
        state.set(GameSwitch.END_ONLY_ON_TIME_LIMIT, on);
    }

    public void setRandomLairExit(boolean on) {
        state.set(GameSwitch.RANDOM_LAIR_EXIT, on);
    }

    /**
     * Switches recorded lair exits on or off ({@link GameSwitch#LAIR_EXIT_DATABASE}).
     *
     * @throws IllegalArgumentException if it is switched on and the rules have no {@link GhostRules#ghostLocations} or
     *     no {@link MazeRules#startingPowerPill}
     */
    public void setLairExitDatabase(boolean on) {
        if (on) {
            state.requireGhostLocations();
        }
        state.set(GameSwitch.LAIR_EXIT_DATABASE, on);
    }

    public void setSimultaneousLairExit(boolean on) {
        state.set(GameSwitch.SIMULTANEOUS_LAIR_EXIT, on);
    }

    public void setGhostsStartOutsideLair(boolean on) {
        state.set(GameSwitch.GHOSTS_START_OUTSIDE_LAIR, on);
    }

    public void setOnlyOneLairExitAllowed(boolean on) {
        state.set(GameSwitch.ONLY_ONE_LAIR_EXIT, on);
    }

    public void setEndAfterGhostEatingChances(boolean on) {
        state.set(GameSwitch.END_AFTER_GHOST_EATING_CHANCES, on);
    }

    public void setEndAfterPowerPillsEaten(boolean on) {
        state.set(GameSwitch.END_AFTER_POWER_PILLS_EATEN, on);
    }

    /**
     * Switches the rule on or off that the corridors of power pills hold no pills. When it is switched on, all pills
     * between each power pill and the next junctions disappear at once. They return with the level after it is switched
     * off. The pill-eating game of the isolated task uses this rule.
     */
    public void setRemovePillsNearPowerPills(boolean on) {
        state.set(GameSwitch.REMOVE_PILLS_NEAR_POWER_PILLS, on);
    }

    /** Removes all pills, now and in later levels. */
    public void playWithoutPills() {
        state.set(GameSwitch.WITHOUT_PILLS, true);
    }

    /** Removes all power pills, now and in later levels. */
    public void playWithoutPowerPills() {
        state.set(GameSwitch.WITHOUT_POWER_PILLS, true);
    }

    /** Pills return with the next level. */
    public void playWithPills() {
        state.set(GameSwitch.WITHOUT_PILLS, false);
    }

    /** Power pills return with the next level. */
    public void playWithPowerPills() {
        state.set(GameSwitch.WITHOUT_POWER_PILLS, false);
    }

    // ---- Counters over the whole game; docs/specification/simulator.md, section 8

    /** Pills and power pills eaten. */
    public int getEatenPills() {
        return state.eatenPills;
    }

    public int getEatenGhosts() {
        return state.eatenGhosts;
    }

    /**
     * How often one ghost, 0 to 3, was eaten.
     *
     * @throws IndexOutOfBoundsException if there is no such ghost
     */
    public int getEatenGhosts(int ghostIndex) {
        return state.ghosts[GameState.EATEN + requireGhost(ghostIndex)];
    }

    /** Sum of the multipliers 1, 2, 4, 8 of the ghosts eaten. */
    public int getGhostReward() {
        return state.ghostReward;
    }

    /**
     * Number of missed chances to eat ghosts. It grows by the number of edible ghosts when Ms.&nbsp;Pac-Man dies, and
     * by 1 for each ghost whose edible time ends. When a power pill is eaten, it grows by the number of active ghosts
     * that are not threats (in the lair or still edible).
     */
    public int getGhostRegret() {
        return state.ghostRegret;
    }

    /** Sum over the eaten ghosts: steps for which the ghost was still edible, times 1, 2, 4 or 8 as for its score. */
    public int getTimeGhostReward() {
        return state.timeGhostReward;
    }

    /** Sum over the eaten pills, without power pills: steps that were left of the level's time limit. */
    public int getTimePillReward() {
        return state.timePillReward;
    }

    /** Power pills eaten while all active ghosts were threats. */
    public int getProperlyEatenPowerPills() {
        return state.properlyEatenPowerPills;
    }

    public int getImproperlyEatenPowerPills() {
        return state.improperlyEatenPowerPills;
    }

    public int getEatenPowerPills() {
        return state.properlyEatenPowerPills + state.improperlyEatenPowerPills;
    }

    public int getPowerPillsEatenWhenGhostFar() {
        return state.powerPillsEatenWhenGhostFar;
    }

    /**
     * Sum of the closeness of threats to the power pills that were eaten; larger is nearer. The closeness of a threat
     * is 200 minus its path distance to Ms.&nbsp;Pac-Man when she eats a power pill, at least 0. The sum starts at
     * -12800 = -(4 levels x 4 power pills x 4 ghosts x 200). It reaches 0 only if all ghosts are on every power pill.
     */
    public double getLureDistanceSum() {
        return state.lureDistance;
    }

    /** Steps in which no pill or power pill was eaten. */
    public long getTimeInDeadSpace() {
        return state.timeInDeadSpace;
    }

    /** Total time before the step of each pill and power pill eaten; null in copies. */
    public @Nullable List<Integer> getPillEatTimes() {
        return state.history == null ? null : state.history.pillEatTimes.toList();
    }

    /** Total time before the step of each ghost eaten; null in copies. */
    public @Nullable List<Integer> getGhostEatTimes() {
        return state.history == null ? null : state.history.ghostEatTimes.toList();
    }

    /**
     * Score gained in a level. Quirk: a call for the level that is being played ends the counting of that level; points
     * gained later count for the next one. So call it after the game, for levels in ascending order.
     *
     * @throws IllegalStateException in a copy
     * @throws IndexOutOfBoundsException if the level was not reached
     */
    public double getScore(int level) {
        return history().levelScore(level, state.score);
    }

    /**
     * Mean number of ghosts eaten per power pill.
     *
     * @param punishUneaten whether the power pills that were not eaten, of all levels of the rules, count as power
     *     pills with 0 ghosts. Quirk: the zeros are kept, so that they count in all later calls too
     * @throws IllegalStateException in a copy
     */
    public double averageGhostsEatenPerPowerPill(boolean punishUneaten) {
        return history().meanGhostsPerPowerPill(punishUneaten, powerPillsInAllLevels());
    }

    /**
     * Mean number of steps from a power pill until all ghosts are eaten; a power pill after which not all were eaten
     * counts as Integer.MAX_VALUE.
     *
     * @throws IllegalStateException in a copy
     */
    public double averageTimeToEatAllGhostsAfterPowerPill() {
        return history().meanTimeToEatAll(powerPillsInAllLevels());
    }

    /** Number of power pills in all levels. It is undefined without a last level. */
    private int powerPillsInAllLevels() {
        int levels = state.rules.levels().maximumLevel();
        return levels == Integer.MAX_VALUE ? 0 : GhostLocations.POWER_PILLS * levels;
    }

    private GameHistory history() {
        if (state.history == null) {
            throw new IllegalStateException("a copy of a game does not know its history");
        }
        return state.history;
    }
}
