package pacman.game;

import java.util.stream.IntStream;
import pacman.game.internal.Maze;
import pacman.maze.MazeTables;
import pacman.maze.Mazes;

/**
 * What differs from one kind of game to another. Immutable; {@link #with()} makes changed copies.
 *
 * <p>Times are in game steps. Source: docs/specification/simulator.md, sections 2 and 7;
 * docs/specification/controllers.md, section 1.3.
 *
 * @param conventions whose behaviour counts where the competition's and MM-NEAT's differ
 * @param copies which random numbers a copy of the game draws
 * @param mazes the mazes of the levels
 * @param initialMaze index of the first level's maze
 * @param onlyMaze index of a maze in which all levels are played, -1 for all mazes in turn
 * @param startingPowerPill number of the power pill on which Ms. Pac-Man starts, -1 for the maze's start
 * @param lives lives at the start
 * @param extraLife whether 10000 points give a life, once per game
 * @param maximumLevel number of levels after which the game is over
 * @param levelTimeLimit steps in a level
 * @param fatalTimeLimit whether reaching the limit is left to the controller, which ends the game; otherwise the next level
 *     starts
 * @param creditForRemainingPills whether half the points of what is left are given at the end of a level
 * @param edibleTime steps for which ghosts are edible in the first level
 * @param infiniteEdibleTime whether ghosts stay edible until they are eaten
 * @param lairTime steps for which an eaten ghost stays in the lair in the first level, at least 2
 * @param imprisonedWhileEdible whether no ghost leaves the lair while another is edible
 * @param randomGhostReversals whether ghosts reverse at random
 * @param activeGhosts number of ghosts that leave the lair, 0 to 4
 * @param closeGhostDistance path distance beyond which all threats count as far when a power pill is eaten
 * @param preEatenPillPortion portion of pills that are missing from the start of a level, in [0, 1]
 * @param powerPillPunishmentRate probability in [0, 1] that the game ends when a ghost's edible time runs out
 * @param dieOnImproperPowerPillEating whether eating a power pill ends the game unless all active ghosts are threats
 * @param switches rules that are switched on the game object
 * @param ghostLocations where ghosts leave the lair under {@link GameSwitches#lairExitDatabase}, in the mazes of the competition
 *     only; otherwise may be null
 */
public record GameRules(
        Conventions conventions,
        Copies copies,
        Mazes mazes,
        int initialMaze,
        int onlyMaze,
        int startingPowerPill,
        int lives,
        boolean extraLife,
        int maximumLevel,
        int levelTimeLimit,
        boolean fatalTimeLimit,
        boolean creditForRemainingPills,
        int edibleTime,
        boolean infiniteEdibleTime,
        int lairTime,
        boolean imprisonedWhileEdible,
        boolean randomGhostReversals,
        int activeGhosts,
        int closeGhostDistance,
        double preEatenPillPortion,
        double powerPillPunishmentRate,
        boolean dieOnImproperPowerPillEating,
        GameSwitches switches,
        GhostLocations ghostLocations) {

    /** Whose behaviour counts where the two frameworks differ; docs/specification/controllers.md, section 1.3. */
    public enum Conventions {
        /**
         * The competition's, release 6.2: a copy is the game's equal, a null move is an illegal move, the state string has
         * 35 fields. What 6.2 draws from outside the game comes from the game's own generator instead.
         */
        COMPETITION,
        /**
         * MM-NEAT's: a copy forgets most switches and what was eaten, a null move from the twelfth step on ends the game, the
         * state string has 56 fields.
         */
        MM_NEAT
    }

    /** Which random numbers a copy of a game draws. */
    public enum Copies {
        /**
         * Those that the game itself will draw: a controller can look into the future in its copy. As in MM-NEAT, where the
         * example ghosts depend on it.
         */
        CONTINUE_THE_GAME,
        /**
         * Numbers of its own, which follow from the game's seed, its time and the number of the copy: each copy shows another
         * possible future, none the real one, and the same seed still gives the same game.
         */
        ARE_INDEPENDENT
    }

    public GameRules {
        if (conventions == null || copies == null || mazes == null || switches == null) {
            throw new IllegalArgumentException("conventions, copies, mazes and switches are needed");
        }
        requireRange("initialMaze", initialMaze, 0, mazes.count() - 1);
        requireRange("onlyMaze", onlyMaze, -1, mazes.count() - 1);
        requireRange("lives", lives, 1, Integer.MAX_VALUE);
        requireRange("maximumLevel", maximumLevel, 1, Integer.MAX_VALUE);
        requireRange("levelTimeLimit", levelTimeLimit, 1, Integer.MAX_VALUE);
        requireRange("edibleTime", edibleTime, 0, Integer.MAX_VALUE);
        // Shortened from level to level it must stay 1 at least: a ghost without lair time moves, which it cannot in
        // the lair.
        requireRange("lairTime", lairTime, 2, Integer.MAX_VALUE);
        requireRange("activeGhosts", activeGhosts, 0, Constants.NUM_GHOSTS);
        requireProbability("preEatenPillPortion", preEatenPillPortion);
        requireProbability("powerPillPunishmentRate", powerPillPunishmentRate);
        if (switches.lairExitDatabase() && (ghostLocations == null || mazes != Mazes.standard())) {
            throw new IllegalArgumentException(
                    "lairExitDatabase needs ghostLocations, which are recorded in the four mazes of the competition");
        }
        requirePowerPill(mazes, startingPowerPill);
    }

    /** Computes the tables of all mazes now; otherwise they are computed when the first game needs them. */
    public void prepareMazes() {
        for (int index = 0; index < mazes.count(); index++) {
            MazeTables maze = mazes.get(index);
            maze.prepare();
            NodeMoves.of(maze);
            Maze.of(maze);
        }
    }

    private static void requireRange(String name, int value, int lowest, int highest) {
        if (value < lowest || value > highest) {
            throw new IllegalArgumentException(name + " must be from " + lowest + " to " + highest + ", is " + value);
        }
    }

    private static void requirePowerPill(Mazes mazes, int powerPill) {
        // The mazes of the competition are not loaded for this.
        int fewest = mazes == Mazes.standard()
                ? GhostLocations.POWER_PILLS
                : IntStream.range(0, mazes.count())
                        .map(index -> mazes.get(index).graph().powerPillCount())
                        .min()
                        .getAsInt();
        requireRange("startingPowerPill", powerPill, -1, fewest - 1);
    }

    private static void requireProbability(String name, double value) {
        if (!(value >= 0 && value <= 1)) {
            throw new IllegalArgumentException(name + " must be from 0 to 1, is " + value);
        }
    }

    /** The competition of 2012, release 6.2: three lives, levels of 4000 steps, no last level; copies foresee nothing. */
    public static GameRules competition() {
        return new Builder()
                .conventions(Conventions.COMPETITION)
                .copies(Copies.ARE_INDEPENDENT)
                .lives(Constants.NUM_LIVES)
                .extraLife(true)
                .maximumLevel(Integer.MAX_VALUE)
                .levelTimeLimit(Constants.LEVEL_LIMIT)
                .fatalTimeLimit(false)
                .build();
    }

    /** MM-NEAT's defaults: the blended game without a level time limit of consequence. */
    public static GameRules mmneat() {
        return new Builder().build();
    }

    /** The blended task of the paper: threats and edible ghosts at once, eaten ghosts come back. */
    public static GameRules blended() {
        return new Builder().levelTimeLimit(8000).build();
    }

    /** The interleaved task of the paper: eaten ghosts stay in the lair while another is edible. */
    public static GameRules interleaved() {
        return new Builder().levelTimeLimit(8000).imprisonedWhileEdible(true).build();
    }

    /** The pill-eating game of the paper's isolated task. */
    public static GameRules isolatedPills() {
        return interleaved().with().switches(GameSwitches.PILL_TASK).build();
    }

    /**
     * A ghost-eating game of the paper's isolated task.
     *
     * @param startingPowerPill corner in which Ms. Pac-Man starts, 0 to 3
     */
    public static GameRules isolatedGhosts(int startingPowerPill, GhostLocations ghostLocations) {
        return interleaved()
                .with()
                .switches(GameSwitches.GHOST_TASK)
                .startingPowerPill(startingPowerPill)
                .ghostLocations(ghostLocations)
                .build();
    }

    /**
     * Ms. Pac-Man vs Ghosts as MM-NEAT evaluates its champions for the competition of 2011: 16 levels of 3000 steps, half
     * credit for what is left. Copies foresee nothing.
     */
    public static GameRules mpmVsGhosts() {
        return new Builder()
                .copies(Copies.ARE_INDEPENDENT)
                .lives(Constants.NUM_LIVES)
                .extraLife(true)
                .maximumLevel(16)
                .levelTimeLimit(3000)
                .fatalTimeLimit(false)
                .creditForRemainingPills(true)
                .build();
    }

    /** Three lives and an extra one through the four mazes. */
    public static GameRules fourMaze() {
        return new Builder()
                .lives(Constants.NUM_LIVES)
                .extraLife(true)
                .levelTimeLimit(50000)
                .build();
    }

    /** A builder that starts from these rules. */
    public Builder with() {
        return new Builder(this);
    }

    /** Builds rules, starting from MM-NEAT's defaults or from given rules; see the record for what each name means. */
    public static final class Builder {

        private Conventions conventions = Conventions.MM_NEAT;
        private Copies copies = Copies.CONTINUE_THE_GAME;
        private Mazes mazes = Mazes.standard();
        private int initialMaze;
        private int onlyMaze = -1;
        private int startingPowerPill = -1;
        private int lives = 1;
        private boolean extraLife;
        private int maximumLevel = 4;
        private int levelTimeLimit = 1000000;
        private boolean fatalTimeLimit = true;
        private boolean creditForRemainingPills;
        private int edibleTime = Constants.EDIBLE_TIME;
        private boolean infiniteEdibleTime;
        private int lairTime = Constants.COMMON_LAIR_TIME;
        private boolean imprisonedWhileEdible;
        private boolean randomGhostReversals = true;
        private int activeGhosts = Constants.NUM_GHOSTS;
        private int closeGhostDistance = 35;
        private double preEatenPillPortion;
        private double powerPillPunishmentRate;
        private boolean dieOnImproperPowerPillEating;
        private GameSwitches switches = GameSwitches.NONE;
        private GhostLocations ghostLocations;

        /** Starts from MM-NEAT's defaults. */
        public Builder() {}

        private Builder(GameRules rules) {
            conventions = rules.conventions;
            copies = rules.copies;
            mazes = rules.mazes;
            initialMaze = rules.initialMaze;
            onlyMaze = rules.onlyMaze;
            startingPowerPill = rules.startingPowerPill;
            lives = rules.lives;
            extraLife = rules.extraLife;
            maximumLevel = rules.maximumLevel;
            levelTimeLimit = rules.levelTimeLimit;
            fatalTimeLimit = rules.fatalTimeLimit;
            creditForRemainingPills = rules.creditForRemainingPills;
            edibleTime = rules.edibleTime;
            infiniteEdibleTime = rules.infiniteEdibleTime;
            lairTime = rules.lairTime;
            imprisonedWhileEdible = rules.imprisonedWhileEdible;
            randomGhostReversals = rules.randomGhostReversals;
            activeGhosts = rules.activeGhosts;
            closeGhostDistance = rules.closeGhostDistance;
            preEatenPillPortion = rules.preEatenPillPortion;
            powerPillPunishmentRate = rules.powerPillPunishmentRate;
            dieOnImproperPowerPillEating = rules.dieOnImproperPowerPillEating;
            switches = rules.switches;
            ghostLocations = rules.ghostLocations;
        }

        public Builder conventions(Conventions value) {
            conventions = value;
            return this;
        }

        public Builder copies(Copies value) {
            copies = value;
            return this;
        }

        public Builder mazes(Mazes value) {
            mazes = value;
            return this;
        }

        public Builder initialMaze(int value) {
            initialMaze = value;
            return this;
        }

        public Builder onlyMaze(int value) {
            onlyMaze = value;
            return this;
        }

        public Builder startingPowerPill(int value) {
            startingPowerPill = value;
            return this;
        }

        public Builder lives(int value) {
            lives = value;
            return this;
        }

        public Builder extraLife(boolean value) {
            extraLife = value;
            return this;
        }

        public Builder maximumLevel(int value) {
            maximumLevel = value;
            return this;
        }

        public Builder levelTimeLimit(int value) {
            levelTimeLimit = value;
            return this;
        }

        public Builder fatalTimeLimit(boolean value) {
            fatalTimeLimit = value;
            return this;
        }

        public Builder creditForRemainingPills(boolean value) {
            creditForRemainingPills = value;
            return this;
        }

        public Builder edibleTime(int value) {
            edibleTime = value;
            return this;
        }

        public Builder infiniteEdibleTime(boolean value) {
            infiniteEdibleTime = value;
            return this;
        }

        public Builder lairTime(int value) {
            lairTime = value;
            return this;
        }

        public Builder imprisonedWhileEdible(boolean value) {
            imprisonedWhileEdible = value;
            return this;
        }

        public Builder randomGhostReversals(boolean value) {
            randomGhostReversals = value;
            return this;
        }

        public Builder activeGhosts(int value) {
            activeGhosts = value;
            return this;
        }

        public Builder closeGhostDistance(int value) {
            closeGhostDistance = value;
            return this;
        }

        public Builder preEatenPillPortion(double value) {
            preEatenPillPortion = value;
            return this;
        }

        public Builder powerPillPunishmentRate(double value) {
            powerPillPunishmentRate = value;
            return this;
        }

        public Builder dieOnImproperPowerPillEating(boolean value) {
            dieOnImproperPowerPillEating = value;
            return this;
        }

        public Builder switches(GameSwitches value) {
            switches = value;
            return this;
        }

        public Builder ghostLocations(GhostLocations value) {
            ghostLocations = value;
            return this;
        }

        /**
         * The rules.
         *
         * @throws IllegalArgumentException if a value is out of its range
         */
        public GameRules build() {
            return new GameRules(
                    conventions,
                    copies,
                    mazes,
                    initialMaze,
                    onlyMaze,
                    startingPowerPill,
                    lives,
                    extraLife,
                    maximumLevel,
                    levelTimeLimit,
                    fatalTimeLimit,
                    creditForRemainingPills,
                    edibleTime,
                    infiniteEdibleTime,
                    lairTime,
                    imprisonedWhileEdible,
                    randomGhostReversals,
                    activeGhosts,
                    closeGhostDistance,
                    preEatenPillPortion,
                    powerPillPunishmentRate,
                    dieOnImproperPowerPillEating,
                    switches,
                    ghostLocations);
        }
    }
}
