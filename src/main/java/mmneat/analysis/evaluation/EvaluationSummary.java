package mmneat.analysis.evaluation;

import java.util.ArrayList;
import java.util.List;
import mmneat.analysis.results.ChampionEvaluation;
import mmneat.mspacman.GameEnd;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;

/** Computes the summary of an evaluation from its games. */
final class EvaluationSummary {

    private static final double LEVEL = 0.95;
    private static final int MAZES = 4;

    private EvaluationSummary() {}

    /** The interval is Student's: the mean of many games is nearly normal, whatever their scores are. */
    static ChampionEvaluation of(long network, Rules rules, long seed, List<GameResult> games) {
        SummaryStatistics scores = new SummaryStatistics();
        long[] deaths = new long[MAZES];
        List<long[]> use = new ArrayList<>();
        for (GameResult game : games) {
            scores.addValue(game.score());
            if (game.end() == GameEnd.LOST_ALL_LIVES) {
                deaths[game.maze()]++;
            }
            for (int s = 0; s < game.moduleUse().size(); s++) {
                long[] counts = game.moduleUse().get(s);
                if (use.size() <= s) {
                    use.add(new long[counts.length]);
                }
                for (int m = 0; m < counts.length; m++) {
                    use.get(s)[m] += counts[m];
                }
            }
        }
        // The sum of whole scores is exact, the running mean of the library is not.
        double mean = scores.getSum() / games.size();
        boolean hasDeviation = games.size() > 1;
        double margin = hasDeviation
                ? new TDistribution(null, games.size() - 1.0).inverseCumulativeProbability((1 + LEVEL) / 2)
                        * scores.getStandardDeviation()
                        / Math.sqrt(games.size())
                : 0;
        return new ChampionEvaluation(
                network,
                rules.label(),
                games.size(),
                seed,
                mean,
                hasDeviation ? scores.getStandardDeviation() : null,
                hasDeviation ? mean - margin : null,
                hasDeviation ? mean + margin : null,
                use,
                deaths);
    }
}
