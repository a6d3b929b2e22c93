package mmneat.mspacman.objectives;

import static mmneat.evolution.ScoreStatistic.AVERAGE;

import java.util.List;
import mmneat.evolution.ScoreStatistic;

/**
 * A score that networks are selected for.
 *
 * @param name the objective's name in files and tables
 * @param score what a game counts
 * @param statistic how trials become one number
 * @param worst the worst score possible in an evaluation: a component of the reference point from which hypervolumes
 *     are measured, and the starting goal of {@link mmneat.evolution.Tug}
 */
public record GameObjective(String name, GameScore score, ScoreStatistic statistic, double worst) {

    /** The two objectives of the published experiments, in their order. */
    public static final List<GameObjective> PUBLISHED =
            List.of(averageOf(GameScore.GHOST_REWARD), averageOf(GameScore.PILLS));

    private static GameObjective averageOf(GameScore score) {
        return new GameObjective(score.name(), score, AVERAGE, 0);
    }

    /** An objective of your own: the average over trials of the score that it computes. */
    public static GameObjective of(Objective own) {
        return new GameObjective(own.name(), new GameScore(own.name(), own::score), AVERAGE, own.worst());
    }
}
