package mmneat.cli.output;

import java.io.PrintWriter;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import mmneat.analysis.statistics.Numbers;
import mmneat.analysis.statistics.TextTable;
import mmneat.experiment.run.ExperimentPlan;
import mmneat.experiment.run.RunMonitor.Phase;
import mmneat.experiment.run.RunOutcome;
import mmneat.experiment.store.RunLayout;
import mmneat.experiment.store.RunStatus;

/** The scores of an experiment's complete runs, best run first. */
public final class ResultTable {

    private static final int MOST_LINES = 40;

    private final ExperimentPlan plan;
    private final List<RunOutcome> outcomes;

    public ResultTable(ExperimentPlan plan, List<RunOutcome> outcomes) {
        this.plan = plan;
        this.outcomes = outcomes;
    }

    public void print(PrintWriter out) {
        List<RunOutcome> complete = outcomes.stream()
                .filter(RunOutcome::isComplete)
                .sorted(Comparator.comparingDouble((RunOutcome outcome) -> -best(outcome)))
                .toList();
        if (!complete.isEmpty()) {
            out.println();
            out.println(plan.name() + ": scores of the final parents");
            TextTable table = new TextTable("run", "best", "median", "folder").alignLeft("folder");
            complete.stream().limit(MOST_LINES).forEach(outcome -> addRun(table, outcome));
            out.print(table.text());
            if (complete.size() > MOST_LINES) {
                out.println("  and " + (complete.size() - MOST_LINES) + " more");
            }
            // A run may have more generations than now requested.
            List<Integer> generations = complete.stream()
                    .map(outcome -> status(outcome).generation())
                    .distinct()
                    .toList();
            if (generations.size() == 1 && generations.get(0) > 0) {
                // As in the original, the champion is that of the generation before the final parents.
                out.println(RunLayout.CHAMPION + ": the best parent of generation " + (generations.get(0) - 1)
                        + ", the last that had children");
            }
        }
        long before = outcomes.stream()
                .filter(outcome -> outcome.phase() == Phase.ALREADY_FINISHED)
                .count();
        if (before > 0) {
            out.println((before == 1 ? "1 run was" : before + " runs were") + " already complete.");
        }
        out.flush();
    }

    /** Returns the complete run with the best champion. */
    public Optional<RunOutcome> best() {
        return outcomes.stream().filter(RunOutcome::isComplete).max(Comparator.comparingDouble(ResultTable::best));
    }

    private static double best(RunOutcome outcome) {
        return status(outcome).best();
    }

    private static RunStatus status(RunOutcome complete) {
        return Objects.requireNonNull(complete.status(), "a complete run has a status");
    }

    private static void addRun(TextTable table, RunOutcome outcome) {
        table.row(
                String.valueOf(outcome.run().number()),
                Numbers.score(status(outcome).best()),
                Numbers.score(status(outcome).median()),
                outcome.run().directory().toString());
    }
}
