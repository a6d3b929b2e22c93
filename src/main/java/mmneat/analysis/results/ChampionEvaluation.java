package mmneat.analysis.results;

import com.fasterxml.jackson.annotation.JsonIgnore;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The summary of many games of a champion, which {@code evaluate} writes into the run's folder.
 *
 * @param network id of the champion
 * @param rules label of the rules of the games: {@code training}, {@code FourMaze} or {@code MPMvsG} ({@link
 *     mmneat.analysis.evaluation.Rules} explains them)
 * @param games number of games; in the isolated version number of trials, each a set of five games
 * @param seed from which the seeds of the games were drawn; null if the file of an earlier program does not tell it
 * @param meanScore average game score
 * @param standardDeviation deviation of the game scores, with n - 1; null for one game
 * @param low lower end of the 95 % confidence interval of the mean; null for one game
 * @param high upper end; null for one game
 * @param moduleUse for each of the {@link #SITUATIONS}, in their order, how often each module decided
 * @param deathsByMaze games that ended by being caught in maze 0, 1, 2, 3
 */
public record ChampionEvaluation(
        long network,
        String rules,
        int games,
        @Nullable Long seed,
        double meanScore,
        @Nullable Double standardDeviation,
        @Nullable Double low,
        @Nullable Double high,
        List<long[]> moduleUse,
        long[] deathsByMaze) {

    /**
     * The situations in which module use is counted, in the order of the original's report: all steps, and those with
     * Ms. Pac-Man at a junction or with an edible ghost present or absent. A step counts in each situation that fits
     * it.
     */
    public static final List<String> SITUATIONS = List.of(
            "all",
            "at junctions",
            "ghost edible",
            "no ghost edible",
            "ghost edible, at junctions",
            "no ghost edible, at junctions");

    /**
     * Minimum number of games for a deviation and an interval; with fewer, both are null. The first versions of the
     * program wrote 0 and the mean.
     */
    private static final int FEWEST_FOR_DEVIATION = 2;

    private static final int MAZES = 4;

    /** Upper limit of scores and objectives, far above those of the best games. */
    public static final double HIGHEST_SCORE = 1e9;

    /**
     * Checks the numbers, because they may come from a damaged file.
     *
     * @throws IllegalArgumentException if a number is impossible, such as a negative deviation; the message names the
     *     first impossible number
     */
    public ChampionEvaluation {
        require(games >= 1, "games", games);
        require(meanScore >= 0 && meanScore <= HIGHEST_SCORE, "meanScore", meanScore);
        if (games < FEWEST_FOR_DEVIATION) {
            require(standardDeviation == null || standardDeviation == 0, "standardDeviation", standardDeviation);
            require(low == null || low == meanScore, "low", low);
            require(high == null || high == meanScore, "high", high);
            standardDeviation = null;
            low = null;
            high = null;
        } else {
            require(
                    standardDeviation != null && Double.isFinite(standardDeviation) && standardDeviation >= 0,
                    "standardDeviation",
                    standardDeviation);
            require(low != null && Double.isFinite(low) && low <= meanScore, "low", low);
            require(high != null && Double.isFinite(high) && high >= meanScore, "high", high);
        }
        require(rules != null, "rules", rules);
        require(
                moduleUse != null && !moduleUse.isEmpty() && moduleUse.size() <= SITUATIONS.size(),
                "moduleUse",
                moduleUse);
        for (long[] counts : moduleUse) {
            boolean areCounts =
                    counts != null && counts.length > 0 && Arrays.stream(counts).allMatch(count -> count >= 0);
            require(areCounts && counts.length == moduleUse.get(0).length, "moduleUse", Arrays.toString(counts));
        }
        boolean areDeaths = deathsByMaze != null
                && deathsByMaze.length == MAZES
                && Arrays.stream(deathsByMaze).allMatch(count -> count >= 0)
                && Arrays.stream(deathsByMaze).sum() <= games;
        require(areDeaths, "deathsByMaze", Arrays.toString(deathsByMaze));
        moduleUse = List.copyOf(moduleUse);
    }

    private static void require(boolean isPossible, String name, @Nullable Object value) {
        if (!isPossible) {
            throw new IllegalArgumentException(name + " cannot be " + value);
        }
    }

    /** Share of the time steps in which the most-used module decided, in percent, as in the paper's figures. */
    @JsonIgnore
    public double mostUsedModulePercent() {
        long[] all = moduleUse.get(0);
        long most = Arrays.stream(all).max().orElse(0);
        return 100.0 * most / Arrays.stream(all).sum();
    }
}
