package mmneat.mspacman.objectives;

import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import pacman.game.Game;
import pacman.game.GameRules;

/**
 * What a finished game is worth in one respect.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 5; the counters are those of docs/specification/simulator.md,
 * section 8.
 *
 * @param name the original's class name
 * @param ofGame the score of a finished game
 */
public record GameScore(String name, ToDoubleFunction<Game> ofGame) {

    /** Ghosts: 1, 2, 4, 8 for those eaten after one power pill. The first objective. */
    public static final GameScore GHOST_REWARD = new GameScore("GhostRewardScore", Game::getGhostReward);

    /** Pills and power pills eaten. The second objective. */
    public static final GameScore PILLS = new GameScore("PillScore", Game::getEatenPills);

    /** Points of the game. */
    public static final GameScore POINTS = new GameScore("GameScore", Game::getScore);

    /** Ghosts eaten per power pill, averaged over all power pills of the game; those not eaten count 0. */
    public static final GameScore GHOSTS_PER_POWER_PILL =
            new GameScore("GhostsPerPowerPillScore", game -> game.averageGhostsEatenPerPowerPill(true));

    /**
     * Meant as the average over eaten power pills only. Quirk of the original: computing {@link #GHOSTS_PER_POWER_PILL} first
     * pads the list that both use, so the two are always equal.
     */
    public static final GameScore GHOSTS_PER_EATEN_POWER_PILL =
            new GameScore("GhostsPerPowerPillScore", game -> game.averageGhostsEatenPerPowerPill(false));

    /** Levels finished. */
    public static final GameScore LEVELS = new GameScore("LevelScore", Game::getCurrentLevel);

    /** Ghosts eaten. */
    public static final GameScore EATEN_GHOSTS = new GameScore("EatenGhostScore", Game::getEatenGhosts);

    /** Missed chances to eat ghosts, negative. */
    public static final GameScore GHOST_REGRET = new GameScore("GhostRegretScore", game -> -game.getGhostRegret());

    /** How near the threats were when power pills were eaten. */
    public static final GameScore LURING = new GameScore("LuringScore", Game::getLureDistanceSum);

    /** Power pills eaten while all ghosts were threats outside the lair. */
    public static final GameScore PROPERLY_EATEN_POWER_PILLS =
            new GameScore("ProperlyEatenPowerPillScore", Game::getProperlyEatenPowerPills);

    /** The other power pills eaten, negative; minus zero if there are none. */
    public static final GameScore IMPROPERLY_EATEN_POWER_PILLS =
            new GameScore("ImproperlyEatenPowerPillScore", game -> -(double) game.getImproperlyEatenPowerPills());

    /** Properly eaten power pills with all ghosts far away, negative; minus zero if there are none. */
    public static final GameScore POWER_PILLS_EATEN_WHEN_GHOSTS_FAR =
            new GameScore("PowerPillEatenWhenGhostFarScore", game -> -(double) game.getPowerPillsEatenWhenGhostFar());

    /** Points made in one level, 0 if it was not reached. The levels of a game must be asked in ascending order. */
    public static GameScore pointsOfLevel(int level) {
        return new GameScore("LevelGameScore", game -> game.getScore(level));
    }

    /**
     * How long she survived, or how quickly she finished: from minus all the time there is, for an early death, through 0, if
     * time ran out, to all the time there is, for clearing all levels at once.
     */
    public static GameScore survivalAndSpeed(GameRules rules) {
        double levelLimit = rules.levels().levelTimeLimit();
        double allTime = levelLimit * rules.levels().maximumLevel();
        return new GameScore("SurvivalAndSpeedTimeScore", game -> {
            if (game.getPacmanNumberOfLivesRemaining() <= 0) {
                return -allTime + game.getCurrentLevel() * levelLimit + game.getCurrentLevelTime();
            }
            return game.getCurrentLevel() < rules.levels().maximumLevel() ? 0 : allTime - game.getTotalTime();
        });
    }

    /** A parameter, recorded because experiments may change it while they run. */
    public static GameScore parameter(String name, double value) {
        return new GameScore(name, game -> value);
    }

    /** The two objectives of the published experiments, in their order. */
    public static List<GameScore> publishedObjectives() {
        return List.of(GHOST_REWARD, PILLS);
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
