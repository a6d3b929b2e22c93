package mmneat.experiment.original;

import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.IntStream;
import mmneat.evolution.Individual;
import mmneat.evolution.SampleStatistics;
import mmneat.experiment.store.RunLayout;

/**
 * The log of module counts, which the original calls ModeUsage. The score of a parent is its mean game score, or
 * in tasks without other scores the first objective. A row has the maximum, minimum and mean number of modules among
 * all parents with the best score, the same for the worst score, and the best score among the parents with one module,
 * with two modules, and so on.
 *
 * <p>Source: docs/specification/evolution.md, section 5.2 (ModeUsage).
 */
final class ModuleCountLog {

    private static final int COUNTED_APART = 5;

    /** The last label says 6 instead of 5, as in the original. */
    private static final List<String> LABELS = List.of(
            "Max Modes of Best",
            "Min Modes of Best",
            "Avg Modes of Best",
            "Max Modes of Worst",
            "Min Modes of Worst",
            "Avg Modes of Worst",
            "1 Mode Best",
            "2 Mode Best",
            "3 Mode Best",
            "4 Mode Best",
            "5 Mode Best",
            "More Than 6 Modes Best");

    private ModuleCountLog() {}

    static String file(String prefix) {
        return RunLayout.log(prefix, RunLayout.MODULE_COUNTS);
    }

    static String plotFile(String prefix) {
        return RunLayout.plot(prefix, RunLayout.MODULE_COUNTS);
    }

    /** The row of a generation. */
    static String row(int generation, List<Individual> parents) {
        DoubleSummaryStatistics scores =
                parents.stream().mapToDouble(ModuleCountLog::score).summaryStatistics();
        double[] values = new double[LABELS.size()];
        modulesOfThoseWith(scores.getMax(), parents, values, 0);
        modulesOfThoseWith(scores.getMin(), parents, values, 3);
        for (int modules = 1; modules <= COUNTED_APART + 1; modules++) {
            values[5 + modules] = bestWith(modules, parents);
        }
        return generation + "\t" + PopulationLog.tabbed(values) + "\n";
    }

    /** Maximum, minimum and mean number of modules among the parents with this score. */
    private static void modulesOfThoseWith(double score, List<Individual> parents, double[] values, int first) {
        double[] modules = parents.stream()
                .filter(parent -> score(parent) == score)
                .mapToDouble(parent -> parent.genotype().modules())
                .toArray();
        SampleStatistics statistics = SampleStatistics.of(modules);
        values[first] = statistics.max();
        values[first + 1] = statistics.min();
        values[first + 2] = statistics.mean();
    }

    /**
     * Returns the best score of the parents with this number of modules; 0 if there are none. The largest number
     * includes all above it.
     */
    private static double bestWith(int modules, List<Individual> parents) {
        return parents.stream()
                .filter(parent -> Math.min(parent.genotype().modules(), COUNTED_APART + 1) == modules)
                .mapToDouble(ModuleCountLog::score)
                .max()
                .orElse(0);
    }

    /**
     * Returns the first of the other scores, which in Ms. Pac-Man is the mean game score; if there are none, the first
     * objective.
     */
    private static double score(Individual individual) {
        double[] others = individual.evaluation().otherScores();
        return others.length > 0 ? others[0] : individual.evaluation().objectives()[0];
    }

    /** The gnuplot script that shows the log. */
    static String plotScript(String prefix) {
        PlotScript script = new PlotScript("set style data lines", "set xlabel \"Generation\"", "set yrange [0:]", "");
        IntStream.range(0, LABELS.size()).forEach(i -> {
            String label = LABELS.get(i);
            script.picture(
                            prefix + RunLayout.MODULE_COUNTS + " " + label,
                            List.of(new PlotScript.Curve(file(prefix), i + 2, label)))
                    .line("");
        });
        return script.toString();
    }
}
