package mmneat.analysis.results;

import com.fasterxml.jackson.annotation.JsonIgnore;
import java.util.Arrays;
import java.util.List;

/**
 * What many games of a champion said of it; the summary that {@code evaluate} leaves in the run's folder.
 *
 * @param network id of the champion
 * @param rules the rules that were played by: training, FourMaze or MPMvsG
 * @param games number of games (trials)
 * @param meanScore average game score
 * @param standardDeviation deviation of the game scores, with n - 1
 * @param low lower end of the 95 % confidence interval of the mean
 * @param high upper end
 * @param moduleUse for each {@link #SITUATIONS observation} how often each module was used
 * @param deathsByMaze games that ended by being caught in maze 0, 1, 2, 3
 */
public record ChampionEvaluation(
        long network,
        String rules,
        int games,
        double meanScore,
        double standardDeviation,
        double low,
        double high,
        List<long[]> moduleUse,
        long[] deathsByMaze) {

    /** The situations in which module use is counted, in the order of the original's report. */
    public static final List<String> SITUATIONS = List.of(
            "all",
            "at junctions",
            "ghost edible",
            "no ghost edible",
            "ghost edible, at junctions",
            "no ghost edible, at junctions");

    public ChampionEvaluation {
        moduleUse = List.copyOf(moduleUse);
    }

    /** Share of the time steps in which the most-used module decided, in percent: the paper's figures. */
    @JsonIgnore
    public double mostUsedModulePercent() {
        long[] all = moduleUse.get(0);
        long most = Arrays.stream(all).max().orElse(0);
        return 100.0 * most / Arrays.stream(all).sum();
    }
}
