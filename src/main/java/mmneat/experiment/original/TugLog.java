package mmneat.experiment.original;

import java.util.List;
import java.util.stream.IntStream;
import mmneat.evolution.ObjectiveGoal;
import mmneat.evolution.TugStep;
import mmneat.experiment.store.RunLayout;

/**
 * The log of targeting unachieved goals (TUG), one row per generation.
 *
 * <p>Source: docs/specification/original-options.md, section 4.5.
 */
final class TugLog {

    private static final int COLUMNS_PER_OBJECTIVE = 7;

    /** Columns of the first objective, counted from 1, after the generation and the flag of active objectives. */
    private static final List<String> CURVES = List.of("Performance", "Goal Target", "RWA", "Goal");

    private static final int FIRST_CURVE = 3;

    private TugLog() {}

    static String file(String prefix) {
        return RunLayout.log(prefix, RunLayout.GOALS);
    }

    static String plotFile(String prefix) {
        return RunLayout.plot(prefix, RunLayout.GOALS);
    }

    /** The row of a generation. */
    static String row(int generation, TugStep step) {
        StringBuilder row = new StringBuilder().append(generation).append('\t');
        double[] performance = step.performance();
        double[] targets = step.targets();
        for (int j = 0; j < performance.length; j++) {
            ObjectiveGoal goal = step.after().goals().get(j);
            row.append(flag(goal.active()))
                    .append(PopulationLog.tabbed(
                            performance[j], targets[j], goal.average(), goal.goal(), goal.lastStep()))
                    .append(flag(goal.climbing()));
        }
        return row.append('\n').toString();
    }

    private static String flag(boolean value) {
        return value ? "1\t" : "0\t";
    }

    /**
     * The gnuplot script that shows the log.
     *
     * @param labels the objectives and, as a quirk of the original, all other scores, for which the log has no columns
     */
    static String plotScript(String prefix, List<String> labels) {
        PlotScript script = new PlotScript("set style data lines", "set xlabel \"Generation\"", "");
        for (int i = 0; i < labels.size(); i++) {
            int first = FIRST_CURVE + COLUMNS_PER_OBJECTIVE * i;
            List<PlotScript.Curve> curves = IntStream.range(0, CURVES.size())
                    .mapToObj(curve -> new PlotScript.Curve(file(prefix), first + curve, CURVES.get(curve)))
                    .toList();
            script.picture(prefix + RunLayout.GOALS + " " + labels.get(i), curves)
                    .line("");
        }
        return script.toString();
    }
}
