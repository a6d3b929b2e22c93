package pacman.game;

import static pacman.game.GameSwitch.END_ONLY_ON_TIME_LIMIT;
import static pacman.game.GameSwitch.EXIT_LAIR_EDIBLE;
import static pacman.game.GameSwitch.LAIR_EXIT_DATABASE;
import static pacman.game.GameSwitch.RANDOM_LAIR_EXIT;
import static pacman.game.GameSwitch.REMOVE_PILLS_NEAR_POWER_PILLS;
import static pacman.game.GameSwitch.SIMULTANEOUS_LAIR_EXIT;
import static pacman.game.GameSwitch.WITHOUT_PILLS;
import static pacman.game.GameSwitch.WITHOUT_POWER_PILLS;

import java.util.Arrays;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.GameRules.Conventions;
import pacman.game.GameRules.Copies;
import pacman.maze.MazeGraph;
import pacman.maze.MazePoses;
import pacman.maze.MazeTables;

/**
 * The state of a game, in fields and small arrays. {@link GameStep} updates it, and {@link LevelStart} starts its
 * levels and lives.
 *
 * <p>Moves are 0 up, 1 right, 2 down, 3 left, 4 none. Source: docs/specification/simulator.md, sections 2.2, 2.8 and 5.
 */
final class GameState {

    static final int NO_MOVE = 4;
    static final int GHOSTS = Constants.NUM_GHOSTS;

    /*
     * All values of ghosts are in one array, so that copying a state copies one array. The index is kind + ghost, where
     * kind is one of these constants.
     */
    /** Node and last move, encoded as in {@link MazePoses}. */
    static final int POSE = 0;

    static final int EDIBLE = 4;
    static final int LAIR = 8;
    /** Times a ghost was eaten in this game. */
    static final int EATEN = 12;

    // Quirk of the original: these switches are off in copies.
    private static final int LOST_IN_COPIES = Stream.of(
                    EXIT_LAIR_EDIBLE,
                    END_ONLY_ON_TIME_LIMIT,
                    RANDOM_LAIR_EXIT,
                    LAIR_EXIT_DATABASE,
                    SIMULTANEOUS_LAIR_EXIT,
                    REMOVE_PILLS_NEAR_POWER_PILLS)
            .mapToInt(lost -> lost.bit)
            .sum();

    /**
     * Factor on edible and lair times by level modulo 6. Because the constant is a float, some products are slightly
     * below integers.
     */
    private static final double[] TIME_FACTORS = IntStream.range(0, Constants.LEVEL_RESET_REDUCTION)
            .mapToDouble(level -> Math.pow(Constants.EDIBLE_TIME_REDUCTION, level))
            .toArray();

    final GameRules rules;
    final ResumableRandom random;
    /** The number from which {@link CopySeeds} derives the seeds of copies. */
    private long copySeed;
    /** Copies made so far of this object. */
    private int copies;
    /** Generator of the run to which the game belongs; null if the game only draws from its own generator. */
    final @Nullable ResumableRandom shared;
    /** The history of the game; null in copies. */
    final @Nullable GameHistory history;

    @SuppressWarnings("NullAway.Init")
    MazeTables tables;

    @SuppressWarnings("NullAway.Init")
    MazeGraph graph;

    @SuppressWarnings("NullAway.Init")
    MazePoses poses;

    int mazeIndex;
    /** Level from 0. */
    int level;
    /** Level that determines edible and lair times. */
    int timesLevel;

    int levelTime;
    int totalTime;
    int score;
    /** Factor on the points for the next ghost: 1, 2, 4, ... */
    int ghostMultiplier;

    int timeOfLastReversal;
    int timeOfLastPowerPill;
    boolean gameOver;
    /** Number of completed calls of advanceGame on this object. */
    int calls;

    /** The switches that are on, as a set of {@link GameSwitch#bit}. */
    int switches;

    /** Ms. Pac-Man's node and last move, encoded as in {@link MazePoses}. */
    int pacManPose;

    int lives;
    boolean extraLifeReceived;

    /** Poses, edible times, lair times and times eaten of the ghosts. */
    final int[] ghosts;

    /**
     * A lower bound of the path distance from Ms. Pac-Man to the nearest ghost outside the lair. Each move reduces it
     * by at most one. So in most steps the bound shows that no ghost is met, without a look-up of distances.
     */
    int minGhostDistance;

    /** Bit set of the pills present, by pill number. */
    @SuppressWarnings("NullAway.Init")
    long[] pills;

    int pillsLeft;
    /** Bit set of the power pills present, by power pill number. */
    long powerPills;

    boolean pacManEaten;
    /** Bit set of the ghosts eaten in the last step. */
    int ghostsEaten;

    boolean pillEaten;
    boolean powerPillEaten;

    // Counters over the whole game; docs/specification/simulator.md, section 8.
    int eatenPills;
    int eatenGhosts;
    int ghostReward;
    int ghostRegret;
    int timeGhostReward;
    int timePillReward;
    int properlyEatenPowerPills;
    int improperlyEatenPowerPills;
    int powerPillsEatenWhenGhostFar;
    long timeInDeadSpace;
    double lureDistance;

    GameState(long seed, GameRules rules, @Nullable ResumableRandom shared) {
        this.rules = rules;
        this.shared = shared;
        random = new ResumableRandom(seed);
        copySeed = seed;
        history = new GameHistory();
        ghosts = new int[4 * GHOSTS];
        start();
    }

    private GameState(GameState other, ResumableRandom random, @Nullable ResumableRandom shared, long copySeed) {
        boolean complete = other.rules.conventions() == Conventions.COMPETITION;
        rules = other.rules;
        this.random = random;
        this.shared = shared;
        this.copySeed = copySeed;
        history = null;
        tables = other.tables;
        graph = other.graph;
        poses = other.poses;
        mazeIndex = other.mazeIndex;
        level = other.level;
        timesLevel = other.timesLevel;
        levelTime = other.levelTime;
        totalTime = other.totalTime;
        score = other.score;
        ghostMultiplier = other.ghostMultiplier;
        timeOfLastReversal = other.timeOfLastReversal;
        gameOver = other.gameOver;
        pacManPose = other.pacManPose;
        lives = other.lives;
        extraLifeReceived = other.extraLifeReceived;
        ghosts = other.ghosts.clone();
        minGhostDistance = other.minGhostDistance;
        pills = other.pills.clone();
        pillsLeft = other.pillsLeft;
        powerPills = other.powerPills;
        ghostsEaten = other.ghostsEaten;
        eatenPills = other.eatenPills;
        eatenGhosts = other.eatenGhosts;
        ghostReward = other.ghostReward;
        ghostRegret = other.ghostRegret;
        timeGhostReward = other.timeGhostReward;
        timePillReward = other.timePillReward;
        properlyEatenPowerPills = other.properlyEatenPowerPills;
        improperlyEatenPowerPills = other.improperlyEatenPowerPills;
        powerPillsEatenWhenGhostFar = other.powerPillsEatenWhenGhostFar;
        timeInDeadSpace = other.timeInDeadSpace;
        lureDistance = other.lureDistance;
        if (complete) {
            switches = other.switches;
            pacManEaten = other.pacManEaten;
            pillEaten = other.pillEaten;
            powerPillEaten = other.powerPillEaten;
        } else {
            switches = other.switches & ~LOST_IN_COPIES;
        }
    }

    /** Returns a copy. The rules determine its random numbers and the switches that it keeps. */
    GameState copy() {
        if (rules.copies() == Copies.CONTINUE_THE_GAME) {
            return snapshot();
        }
        long seed = nextCopySeed();
        return new GameState(this, new ResumableRandom(seed), null, seed);
    }

    /**
     * Returns a copy that continues the generators and does not count as a copy. It is for views, not for controllers.
     */
    GameState snapshot() {
        return new GameState(this, random.copy(), shared, copySeed);
    }

    /** Sets a generator to the state of the next copy's generator, and counts as that copy. */
    void continueAsCopy(ResumableRandom scratch) {
        if (rules.copies() == Copies.CONTINUE_THE_GAME) {
            scratch.continueAs(random);
        } else {
            scratch.setSeed(nextCopySeed());
        }
    }

    private long nextCopySeed() {
        return CopySeeds.of(copySeed, totalTime, ++copies);
    }

    /** Starts the game again with the random numbers of a seed. */
    void restart(long seed) {
        random.setSeed(seed);
        copySeed = seed;
        copies = 0;
        if (history != null) {
            history.clear();
        }
        level = 0;
        levelTime = 0;
        totalTime = 0;
        score = 0;
        gameOver = false;
        calls = 0;
        extraLifeReceived = false;
        clearFlags();
        eatenPills = 0;
        eatenGhosts = 0;
        ghostReward = 0;
        ghostRegret = 0;
        timeGhostReward = 0;
        timePillReward = 0;
        properlyEatenPowerPills = 0;
        improperlyEatenPowerPills = 0;
        powerPillsEatenWhenGhostFar = 0;
        timeInDeadSpace = 0;
        Arrays.fill(ghosts, EATEN, EATEN + GHOSTS, 0);
        start();
    }

    private void start() {
        timeOfLastReversal = -1;
        timeOfLastPowerPill = -1;
        lureDistance = -(4.0 * 4 * 4 * 200);
        lives = rules.levels().lives();
        mazeIndex = rules.mazes().onlyMaze() >= 0
                ? rules.mazes().onlyMaze()
                : rules.mazes().initialMaze();
        timesLevel = Math.max(0, rules.mazes().onlyMaze());
        // Pills are set before the switches, as in the original's constructor.
        switches = 0;
        enterMaze();
        LevelPills.fill(this);
        LevelPills.fillPowerPills(this);
        LevelStart.resetPositions(this);
        applySwitches(rules.switches());
    }

    void clearFlags() {
        pacManEaten = false;
        ghostsEaten = 0;
        pillEaten = false;
        powerPillEaten = false;
    }

    private void applySwitches(Set<GameSwitch> on) {
        if (on.contains(LAIR_EXIT_DATABASE)) {
            requireGhostLocations();
        }
        on.forEach(each -> set(each, true));
    }

    /** Checks that the ghost locations needed by {@link GameSwitch#LAIR_EXIT_DATABASE} exist. */
    void requireGhostLocations() {
        if (rules.ghosts().ghostLocations() == null || rules.mazes().startingPowerPill() < 0) {
            throw new IllegalArgumentException("lairExitDatabase needs ghostLocations and a startingPowerPill");
        }
    }

    /** Turns a switch on or off. Switching pills off removes them immediately; switching them on restores none. */
    void set(GameSwitch rule, boolean on) {
        switches = on ? switches | rule.bit : switches & ~rule.bit;
        if (!on) {
            return;
        }
        if (rule == WITHOUT_PILLS) {
            Arrays.fill(pills, 0);
            pillsLeft = 0;
        } else if (rule == WITHOUT_POWER_PILLS) {
            powerPills = 0;
        } else if (rule == REMOVE_PILLS_NEAR_POWER_PILLS) {
            LevelPills.removeNearPowerPills(this);
        }
    }

    boolean has(GameSwitch rule) {
        return (switches & rule.bit) != 0;
    }

    /** Looks up the maze of {@link #mazeIndex}. */
    void enterMaze() {
        tables = rules.mazes().mazes().get(mazeIndex);
        graph = tables.graph();
        poses = tables.poses();
    }

    boolean hasPill(int pill) {
        return pill >> 6 < pills.length && (pills[pill >> 6] >>> pill & 1) != 0;
    }

    void removePill(int pill) {
        pills[pill >> 6] &= ~(1L << pill);
        pillsLeft--;
    }

    /**
     * Index of the maze of Ms. Pac-Man and the ghosts. After the last level {@link #mazeIndex} is that of the next
     * maze.
     */
    int shownMazeIndex() {
        int levelsBeyond = level - (rules.levels().maximumLevel() - 1);
        return levelsBeyond <= 0 || rules.mazes().onlyMaze() >= 0
                ? mazeIndex
                : Math.floorMod(mazeIndex - levelsBeyond, rules.mazes().mazes().count());
    }

    /** An edible or lair time of the first level, shortened for the current one. */
    int scaledTime(int base) {
        return (int) (base * TIME_FACTORS[timesLevel % Constants.LEVEL_RESET_REDUCTION]);
    }

    int newEdibleTime() {
        return scaledTime(rules.ghosts().edibleTime());
    }

    boolean isAnyEdible() {
        return (ghosts[EDIBLE] | ghosts[EDIBLE + 1] | ghosts[EDIBLE + 2] | ghosts[EDIBLE + 3]) != 0;
    }

    boolean isAnyInLair() {
        return (ghosts[LAIR] | ghosts[LAIR + 1] | ghosts[LAIR + 2] | ghosts[LAIR + 3]) != 0;
    }

    /** Whether a ghost moves: it is outside the lair, and this is not a step in which it rests because it is edible. */
    boolean mayMove(int ghost) {
        int edible = ghosts[EDIBLE + ghost];
        return ghosts[LAIR + ghost] == 0 && (edible == 0 || (edible & 1) != 0);
    }

    /**
     * Whether a ghost may choose a direction: it is at a junction or just left the lair, and does not rest in this
     * step.
     */
    boolean requiresAction(int ghost) {
        int edible = ghosts[EDIBLE + ghost];
        return poses.isChoice(ghosts[POSE + ghost]) && (edible == 0 || (edible & 1) != 0);
    }

    int edibleGhosts() {
        int count = 0;
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            count += ghosts[EDIBLE + ghost] > 0 ? 1 : 0;
        }
        return count;
    }

    int pacManNode() {
        return MazePoses.node(pacManPose);
    }

    int ghostNode(int ghost) {
        return MazePoses.node(ghosts[POSE + ghost]);
    }

    int ghostMove(int ghost) {
        return MazePoses.move(ghosts[POSE + ghost]);
    }

    /** Whether a ghost is a threat: neither edible nor in the lair. */
    boolean isThreat(int ghost) {
        return ghosts[EDIBLE + ghost] == 0 && graph.degree(ghostNode(ghost)) > 0;
    }

    /** The generator for random numbers that the original does not draw from the game's generator. */
    ResumableRandom taskRandom() {
        return shared == null ? random : shared;
    }
}
