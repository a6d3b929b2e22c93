package pacman.game;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;
import java.util.function.UnaryOperator;
import pacman.game.internal.Maze;
import pacman.maze.MazeTables;

/**
 * The rules of a game. Start from a preset such as {@link #competition} or {@link #blended}. Immutable; the methods
 * {@code with...} return changed copies, as in {@code GameRules.competition().withLevels(levels ->
 * levels.withLives(1))}.
 *
 * <p>Source: docs/specification/simulator.md, sections 2 and 7; docs/specification/controllers.md, section 1.3.
 *
 * @param conventions which framework's behaviour is used where the competition and MM-NEAT differ
 * @param copies the random numbers that a copy of the game draws
 * @param mazes the mazes and where the game starts
 * @param levels levels and lives
 * @param ghosts the ghosts and their times
 * @param pills the pills and what power pills cost
 * @param switches switches that are on at the start of a game
 */
public record GameRules(
        Conventions conventions,
        Copies copies,
        MazeRules mazes,
        LevelRules levels,
        GhostRules ghosts,
        PillRules pills,
        Set<GameSwitch> switches) {

    /**
     * The framework whose behaviour is used where the competition's framework and MM-NEAT differ. Source:
     * docs/specification/controllers.md, section 1.3.
     */
    public enum Conventions {
        /**
         * The competition, release 6.2: a copy equals the game, a null move is an illegal move, the state string has 35
         * fields. Random numbers that release 6.2 draws from a global generator come from the game's own generator.
         */
        COMPETITION,
        /**
         * MM-NEAT: a copy lacks most switches and the record of what was eaten ({@link Game#copy} lists them), a null
         * move from the twelfth step on ends the game, the state string has 56 fields.
         */
        MM_NEAT
    }

    /**
     * The random numbers that a copy of a game draws. Use {@link #ARE_INDEPENDENT} where controllers compete, and
     * {@link #CONTINUE_THE_GAME} to get the results of MM-NEAT.
     */
    public enum Copies {
        /**
         * The same numbers that the game will draw, so a controller can see the future in its copy. This is the
         * behaviour of MM-NEAT, on which the example ghosts depend.
         */
        CONTINUE_THE_GAME,
        /**
         * Separate numbers, which follow from the game's seed, its time and the number of the copy. Each copy shows
         * another possible future and none shows the real one. The same seed still gives the same game.
         */
        ARE_INDEPENDENT
    }

    /**
     * @throws IllegalArgumentException if the parts are inconsistent
     */
    public GameRules {
        if (conventions == null
                || copies == null
                || mazes == null
                || levels == null
                || ghosts == null
                || pills == null
                || switches == null) {
            throw new IllegalArgumentException("all parts of the rules are needed");
        }
        EnumSet<GameSwitch> ordered = EnumSet.noneOf(GameSwitch.class);
        ordered.addAll(switches);
        switches = Collections.unmodifiableSet(ordered);
        if (switches.contains(GameSwitch.LAIR_EXIT_DATABASE)
                && (ghosts.ghostLocations() == null || mazes.mazes() != MazeRules.MM_NEAT.mazes())) {
            throw new IllegalArgumentException(
                    "lairExitDatabase needs ghostLocations, which are recorded in the four mazes of the competition");
        }
    }

    /** Computes the tables of all mazes now; otherwise they are computed when the first game needs them. */
    public void prepareMazes() {
        for (int index = 0; index < mazes.mazes().count(); index++) {
            MazeTables maze = mazes.mazes().get(index);
            maze.prepare();
            NodeMoves.of(maze);
            Maze.of(maze);
        }
    }

    static void requireRange(String name, int value, int lowest, int highest) {
        if (value < lowest || value > highest) {
            throw new IllegalArgumentException(name + " must be from " + lowest + " to " + highest + ", is " + value);
        }
    }

    static void requireProbability(String name, double value) {
        if (!(value >= 0 && value <= 1)) {
            throw new IllegalArgumentException(name + " must be from 0 to 1, is " + value);
        }
    }

    /** The competition of 2012, release 6.2: three lives, levels of 4000 steps, no last level, independent copies. */
    public static GameRules competition() {
        return mmneat().withConventions(Conventions.COMPETITION)
                .withCopies(Copies.ARE_INDEPENDENT)
                .withLevels(levels -> levels.withLives(Constants.NUM_LIVES)
                        .withExtraLife(true)
                        .withMaximumLevel(Integer.MAX_VALUE)
                        .withLevelTimeLimit(Constants.LEVEL_LIMIT)
                        .withFatalTimeLimit(false));
    }

    /** MM-NEAT's defaults: the blended game with practically no level time limit. */
    public static GameRules mmneat() {
        return new GameRules(
                Conventions.MM_NEAT,
                Copies.CONTINUE_THE_GAME,
                MazeRules.MM_NEAT,
                LevelRules.MM_NEAT,
                GhostRules.MM_NEAT,
                PillRules.MM_NEAT,
                Set.of());
    }

    /** The blended task of the paper: threats and edible ghosts at the same time; eaten ghosts return. */
    public static GameRules blended() {
        return mmneat().withLevels(levels -> levels.withLevelTimeLimit(8000));
    }

    /** The interleaved task of the paper: eaten ghosts stay in the lair while another is edible. */
    public static GameRules interleaved() {
        return blended().with(Set.of(GameSwitch.IMPRISONED_WHILE_EDIBLE));
    }

    /**
     * The pill-eating game of the paper's isolated task. That task separates the parts of the game: one game without
     * power pills, in which only pills are eaten, and four games without pills, in which all ghosts are edible from the
     * start ({@link #isolatedGhosts}).
     */
    public static GameRules isolatedPills() {
        return interleaved().with(GameSwitch.PILL_TASK);
    }

    /**
     * A ghost-eating game of the paper's isolated task: no pills; in each level all ghosts leave the lair edible, and
     * the level ends when none is edible any more.
     *
     * @param startingPowerPill number of the power pill on whose node Ms. Pac-Man starts, 0 to 3
     * @param ghostLocations recorded nodes, from which the places of the ghosts are drawn
     */
    public static GameRules isolatedGhosts(int startingPowerPill, GhostLocations ghostLocations) {
        return interleaved()
                .withGhosts(ghosts -> ghosts.withGhostLocations(ghostLocations))
                .with(GameSwitch.GHOST_TASK)
                .withMazes(mazes -> mazes.withStartingPowerPill(startingPowerPill));
    }

    /**
     * The rules with which MM-NEAT evaluates its champions for the competition of 2011: 16 levels of 3000 steps, half
     * credit for remaining pills, independent copies.
     */
    public static GameRules mpmVsGhosts() {
        return mmneat().withCopies(Copies.ARE_INDEPENDENT).withLevels(levels -> levels.withLives(Constants.NUM_LIVES)
                .withExtraLife(true)
                .withMaximumLevel(16)
                .withCreditForRemainingPills(true)
                .withLevelTimeLimit(3000)
                .withFatalTimeLimit(false));
    }

    /**
     * The rules of MM-NEAT's FourMaze evaluation of champions: three lives, an extra life at 10000 points, one level in
     * each of the four mazes, and a time limit of 50000 steps per level. {@link #competition}, in contrast, has no last
     * level, levels of 4000 steps, and independent copies.
     */
    public static GameRules fourMaze() {
        return mmneat().withLevels(levels ->
                levels.withLives(Constants.NUM_LIVES).withExtraLife(true).withLevelTimeLimit(50000));
    }

    /** Returns these rules with other conventions. */
    public GameRules withConventions(Conventions value) {
        return new GameRules(value, copies, mazes, levels, ghosts, pills, switches);
    }

    /** Returns these rules with other random numbers of copies. */
    public GameRules withCopies(Copies value) {
        return new GameRules(conventions, value, mazes, levels, ghosts, pills, switches);
    }

    /** Returns these rules with other mazes or another start. */
    public GameRules withMazes(UnaryOperator<MazeRules> change) {
        return new GameRules(conventions, copies, change.apply(mazes), levels, ghosts, pills, switches);
    }

    /** Returns these rules with other levels or lives. */
    public GameRules withLevels(UnaryOperator<LevelRules> change) {
        return new GameRules(conventions, copies, mazes, change.apply(levels), ghosts, pills, switches);
    }

    /** Returns these rules with other rules for the ghosts. */
    public GameRules withGhosts(UnaryOperator<GhostRules> change) {
        return new GameRules(conventions, copies, mazes, levels, change.apply(ghosts), pills, switches);
    }

    /** Returns these rules with other rules for the pills. */
    public GameRules withPills(UnaryOperator<PillRules> change) {
        return new GameRules(conventions, copies, mazes, levels, ghosts, change.apply(pills), switches);
    }

    /** Returns these rules with more switches on. */
    public GameRules with(Set<GameSwitch> on) {
        Set<GameSwitch> changed = EnumSet.noneOf(GameSwitch.class);
        changed.addAll(switches);
        changed.addAll(on);
        return withSwitches(changed);
    }

    /** Returns these rules with some switches off. */
    public GameRules without(Set<GameSwitch> off) {
        Set<GameSwitch> changed = EnumSet.allOf(GameSwitch.class);
        changed.retainAll(switches);
        changed.removeAll(off);
        return withSwitches(changed);
    }

    /** Returns these rules with exactly the given switches on. */
    public GameRules withSwitches(Set<GameSwitch> value) {
        return new GameRules(conventions, copies, mazes, levels, ghosts, pills, value);
    }
}
