package mmneat.analysis.results;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;

/**
 * The results of a run, read from its folder.
 *
 * @param folder the run's folder
 * @param number the run's number
 * @param parameters its parameters, by name
 * @param championScores the champion's average score in each generation, from generation 0
 * @param evaluation the champion's evaluation after evolution under the training rules, if there was one
 */
public record RunResult(
        Path folder,
        int number,
        Map<String, String> parameters,
        double[] championScores,
        Optional<ChampionEvaluation> evaluation) {

    /** The best score in the last generation. */
    public double lastScore() {
        return championScores[championScores.length - 1];
    }

    /** The champion's score in the generation in which it was chosen: the last that had children. */
    public double scoreOfChampion() {
        return championScores[Math.max(0, championScores.length - 2)];
    }

    /** Number of generations that were evolved. */
    public int generations() {
        return championScores.length - 1;
    }

    /** Whether the run is finished and its champion was evaluated: only then does its score stand beside others. */
    public boolean isComparable() {
        return !isUnfinished() && evaluation.isPresent();
    }

    /** Whether fewer generations were evolved than its parameters ask for. */
    public boolean isUnfinished() {
        String asked = parameters.getOrDefault("maxGens", "");
        return asked.matches("\\d{1,9}") && generations() < Integer.parseInt(asked);
    }
}
