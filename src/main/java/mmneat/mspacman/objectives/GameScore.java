package mmneat.mspacman.objectives;

import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import pacman.game.Game;
import pacman.game.GameRules;

/**
 * A score of a finished game, such as the number of eaten pills.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 5; the counters are those of docs/specification/simulator.md,
 * section 8.
 *
 * @param name the original's class name
 * @param ofGame computes the score of a finished game
 */
public record GameScore(String name, ToDoubleFunction<Game> ofGame) {

    static final String SURVIVAL_AND_SPEED = "SurvivalAndSpeedTimeScore";

    /** Eaten ghosts, weighted 1, 2, 4, 8 in the order eaten after one power pill. The first objective. */
    public static final GameScore GHOST_REWARD = new GameScore("GhostRewardScore", Game::getGhostReward);

    /** Pills and power pills eaten. The second objective. */
    public static final GameScore PILLS = new GameScore("PillScore", Game::getEatenPills);

    /** Points of the game. */
    public static final GameScore POINTS = new GameScore("GameScore", Game::getScore);

    /** Ghosts eaten per power pill, averaged over all power pills of the game; those not eaten count 0. */
    public static final GameScore GHOSTS_PER_POWER_PILL =
            new GameScore("GhostsPerPowerPillScore", game -> game.averageGhostsEatenPerPowerPill(true));

    /**
     * Ghosts eaten per power pill, intended as the average over eaten power pills only. Quirk of the original:
     * computing {@link #GHOSTS_PER_POWER_PILL} first pads the list that both use, so the two are always equal.
     */
    public static final GameScore GHOSTS_PER_EATEN_POWER_PILL =
            new GameScore("GhostsPerPowerPillScore", game -> game.averageGhostsEatenPerPowerPill(false));

    /** Levels finished. */
    public static final GameScore LEVELS = new GameScore("LevelScore", Game::getCurrentLevel);

    /** Ghosts eaten. */
    public static final GameScore EATEN_GHOSTS = new GameScore("EatenGhostScore", Game::getEatenGhosts);

    /** Missed chances to eat ghosts, negative. */
    public static final GameScore GHOST_REGRET = new GameScore("GhostRegretScore", game -> -game.getGhostRegret());

    /**
     * Closeness of the threats when power pills were eaten, at least -12800; larger is better. It rewards waiting at a
     * power pill until ghosts are near. {@link Game#getLureDistanceSum} has the formula.
     */
    public static final GameScore LURING = new GameScore("LuringScore", Game::getLureDistanceSum);

    /** Power pills eaten while all ghosts were threats outside the lair. */
    public static final GameScore PROPERLY_EATEN_POWER_PILLS =
            new GameScore("ProperlyEatenPowerPillScore", Game::getProperlyEatenPowerPills);

    /** The other power pills eaten, negative; minus zero if there are none. */
    public static final GameScore IMPROPERLY_EATEN_POWER_PILLS =
            new GameScore("ImproperlyEatenPowerPillScore", game -> -(double) game.getImproperlyEatenPowerPills());

    /**
     * Minus the number of properly eaten power pills for which all ghosts were farther away than {@link
     * pacman.game.PillRules#closeGhostDistance}; minus zero if there are none.
     */
    public static final GameScore POWER_PILLS_EATEN_WHEN_GHOSTS_FAR =
            new GameScore("PowerPillEatenWhenGhostFarScore", game -> -(double) game.getPowerPillsEatenWhenGhostFar());

    /** Points scored in one level; 0 if it was not reached. Compute the levels of a game in ascending order. */
    public static GameScore pointsOfLevel(int level) {
        return new GameScore("LevelGameScore", game -> game.getScore(level));
    }

    /**
     * Survival time and speed combined: minus the whole time limit for an immediate death, 0 if time ran out, plus the
     * whole time limit for clearing all levels immediately.
     */
    public static GameScore survivalAndSpeed(GameRules rules) {
        double levelLimit = rules.levels().levelTimeLimit();
        double allTime = levelLimit * rules.levels().maximumLevel();
        return new GameScore(SURVIVAL_AND_SPEED, game -> {
            if (game.getPacmanNumberOfLivesRemaining() <= 0) {
                return -allTime + game.getCurrentLevel() * levelLimit + game.getCurrentLevelTime();
            }
            return game.getCurrentLevel() < rules.levels().maximumLevel() ? 0 : allTime - game.getTotalTime();
        });
    }

    /**
     * A constant that looks like a score: the value of a parameter of the run, such as the edible time. The original
     * records two parameters among the scores, because its experiments may change them during a run.
     */
    public static GameScore parameter(String name, double value) {
        return new GameScore(name, game -> value);
    }

    /** The score of a finished game. */
    public double of(Game game) {
        return ofGame.applyAsDouble(game);
    }

    /** Points of the levels 0 to 3. */
    static Stream<GameScore> pointsOfLevels() {
        return IntStream.range(0, 4).mapToObj(GameScore::pointsOfLevel);
    }
}
