package pacman.game;

/**
 * The rules for the levels and lives of a game. Immutable. Times are in game steps.
 *
 * <p>Source: docs/specification/simulator.md, sections 2 and 7.
 *
 * @param lives lives at the start
 * @param extraLife whether 10000 points give a life, once per game
 * @param maximumLevel number of levels after which the game is over; {@link Integer#MAX_VALUE} for no last level
 * @param creditForRemainingPills whether half the points of the remaining pills are given at the end of a level
 * @param levelTimeLimit steps in a level
 * @param fatalTimeLimit whether the time limit ends the game. The engine then does nothing at the limit, as in MM-NEAT:
 *     Ms. Pac-Man's controller of the task must end the game by a null move, and other controllers may play on. If
 *     false, the engine starts the next level at the limit
 */
public record LevelRules(
        int lives,
        boolean extraLife,
        int maximumLevel,
        boolean creditForRemainingPills,
        int levelTimeLimit,
        boolean fatalTimeLimit) {

    /** MM-NEAT's defaults: one life and four levels with practically no time limit. */
    static final LevelRules MM_NEAT = new LevelRules(1, false, 4, false, 1000000, true);

    /** @throws IllegalArgumentException if a value is out of its range */
    public LevelRules {
        GameRules.requireRange("lives", lives, 1, Integer.MAX_VALUE);
        GameRules.requireRange("maximumLevel", maximumLevel, 1, Integer.MAX_VALUE);
        GameRules.requireRange("levelTimeLimit", levelTimeLimit, 1, Integer.MAX_VALUE);
    }

    public LevelRules withLives(int value) {
        return new LevelRules(value, extraLife, maximumLevel, creditForRemainingPills, levelTimeLimit, fatalTimeLimit);
    }

    public LevelRules withExtraLife(boolean value) {
        return new LevelRules(lives, value, maximumLevel, creditForRemainingPills, levelTimeLimit, fatalTimeLimit);
    }

    public LevelRules withMaximumLevel(int value) {
        return new LevelRules(lives, extraLife, value, creditForRemainingPills, levelTimeLimit, fatalTimeLimit);
    }

    public LevelRules withCreditForRemainingPills(boolean value) {
        return new LevelRules(lives, extraLife, maximumLevel, value, levelTimeLimit, fatalTimeLimit);
    }

    public LevelRules withLevelTimeLimit(int value) {
        return new LevelRules(lives, extraLife, maximumLevel, creditForRemainingPills, value, fatalTimeLimit);
    }

    public LevelRules withFatalTimeLimit(boolean value) {
        return new LevelRules(lives, extraLife, maximumLevel, creditForRemainingPills, levelTimeLimit, value);
    }
}
