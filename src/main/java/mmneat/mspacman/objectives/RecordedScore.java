package mmneat.mspacman.objectives;

import static mmneat.evolution.ScoreStatistic.AVERAGE;
import static mmneat.evolution.ScoreStatistic.MAX;
import static mmneat.evolution.ScoreStatistic.MODE;

import java.util.ArrayList;
import java.util.List;
import mmneat.evolution.ScoreStatistic;
import pacman.game.GameRules;

/**
 * A score that is recorded but not used by selection, with the statistic that combines its trials.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 5.
 *
 * @param score the score of each trial
 * @param statistic combines the trials into one number
 */
public record RecordedScore(GameScore score, ScoreStatistic statistic) {

    /** Returns the 26 scores of the original in its order, which matters because some scores have side effects. */
    public static List<RecordedScore> ofTheOriginal(GameRules rules) {
        GameScore survival = GameScore.survivalAndSpeed(rules);
        List<RecordedScore> recorded = new ArrayList<>();
        add(recorded, GameScore.POINTS, AVERAGE, MAX);
        add(recorded, GameScore.PILLS, AVERAGE, MAX);
        add(recorded, GameScore.GHOSTS_PER_POWER_PILL, AVERAGE);
        add(recorded, GameScore.GHOSTS_PER_EATEN_POWER_PILL, AVERAGE);
        add(recorded, GameScore.GHOST_REWARD, AVERAGE, MAX);
        add(recorded, GameScore.LEVELS, AVERAGE, MAX, MODE);
        add(recorded, GameScore.EATEN_GHOSTS, AVERAGE, MAX);
        add(recorded, GameScore.GHOST_REGRET, AVERAGE);
        add(recorded, GameScore.LURING, AVERAGE);
        add(recorded, GameScore.PROPERLY_EATEN_POWER_PILLS, AVERAGE);
        add(recorded, GameScore.IMPROPERLY_EATEN_POWER_PILLS, AVERAGE);
        add(recorded, GameScore.POWER_PILLS_EATEN_WHEN_GHOSTS_FAR, AVERAGE);
        add(recorded, survival, AVERAGE, MAX);
        GameScore.pointsOfLevels().forEach(points -> add(recorded, points, AVERAGE));
        add(recorded, GameScore.parameter("EdibleTimeParameter", rules.ghosts().edibleTime()), AVERAGE);
        add(recorded, GameScore.parameter("LairTimeParameter", rules.ghosts().lairTime()), AVERAGE);
        return List.copyOf(recorded);
    }

    private static void add(List<RecordedScore> recorded, GameScore score, ScoreStatistic... statistics) {
        for (ScoreStatistic statistic : statistics) {
            recorded.add(new RecordedScore(score, statistic));
        }
    }

    /** The score's name, with the statistic if it is not the average: {@code GameScore[Max]}. */
    public String label() {
        return statistic == AVERAGE ? score.name() : score.name() + "[" + statistic.label() + "]";
    }
}
