package pacman;

import java.util.List;

/**
 * The scores of a series of games between two controllers.
 *
 * @param scores the score of each game, in the order of the games; at least one
 * @param steps total steps of all games
 */
public record ExperimentResult(List<Integer> scores, long steps) {

    /** @throws IllegalArgumentException if there is no score */
    public ExperimentResult {
        scores = List.copyOf(scores);
        if (scores.isEmpty()) {
            throw new IllegalArgumentException("an experiment must have at least one game");
        }
    }

    /** Mean score. */
    public double mean() {
        return scores.stream().mapToInt(Integer::intValue).average().orElseThrow();
    }
}
