package mmneat.analysis.results;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.StopScore;

/**
 * The results of a run, read from its folder.
 *
 * @param folder the run's folder
 * @param number the run's number
 * @param parameters its parameters, by name
 * @param championScores for each generation, from generation 0, the best mean game score among its parents (that of the
 *     champion of this generation); the last entry is of the final parents, which have no children
 * @param evaluation the champion's evaluation after evolution under the training rules, if there was one
 */
public record RunResult(
        Path folder,
        int number,
        Map<String, String> parameters,
        double[] championScores,
        Optional<ChampionEvaluation> evaluation) {

    /** The best score among the final parents, which are evaluated but have no children. */
    public double lastScore() {
        return championScores[championScores.length - 1];
    }

    /**
     * The score of the run's champion when it was chosen. As in the original, the champion is chosen among the parents
     * of the last generation that had children, one generation before the final parents ({@link #lastScore}).
     */
    public double scoreOfChampion() {
        return championScores[Math.max(0, championScores.length - 2)];
    }

    /** Number of generations that were evolved. */
    public int generations() {
        return championScores.length - 1;
    }

    /**
     * Whether the run is finished and its champion was evaluated after evolution. Comparisons by evaluations take only
     * such runs; comparisons by the last generation take all finished runs.
     */
    public boolean isComparable() {
        return !isUnfinished() && evaluation.isPresent();
    }

    /**
     * Whether fewer generations were evolved than its parameters ask for. A run that {@code stopAt} ended early is
     * finished.
     */
    public boolean isUnfinished() {
        String asked = parameters.getOrDefault("maxGens", "");
        return asked.matches("\\d{1,9}") && generations() < Integer.parseInt(asked) && !hasReachedItsScore();
    }

    private boolean hasReachedItsScore() {
        try {
            return lastScore() >= StopScore.of(parameters);
        } catch (UserError e) {
            // From the damaged file of another person: the run has no score to reach.
            return false;
        }
    }
}
