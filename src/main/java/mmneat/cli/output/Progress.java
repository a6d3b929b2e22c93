package mmneat.cli.output;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import mmneat.analysis.statistics.Numbers;
import mmneat.experiment.run.ExperimentPlan;
import mmneat.experiment.run.RunMonitor;
import mmneat.experiment.run.RunMonitor.Phase;
import mmneat.experiment.run.RunMonitor.Snapshot;
import org.jspecify.annotations.Nullable;

/**
 * The progress of an experiment: one line per active run and one for all runs, which a {@link ProgressTicker} shows.
 */
public final class Progress {

    /** Maximum number of active runs that have their own line. */
    private static final int MOST_LINES = 16;

    private final List<RunMonitor> monitors;

    /** Null if no progress is shown. */
    private @Nullable ProgressTicker ticker;

    private double portionAtStart = Double.NaN;
    private long startNanos;

    private Progress(List<RunMonitor> monitors) {
        this.monitors = monitors;
    }

    /** Starts to show progress, unless {@code quiet}. */
    public static Progress start(boolean quiet, PrintWriter out, ExperimentPlan plan, List<RunMonitor> monitors) {
        Progress progress = new Progress(monitors);
        if (!quiet) {
            out.println(plan.name() + ": "
                    + (plan.runs().size() == 1
                            ? "run " + plan.runs().get(0).number() + " in "
                                    + plan.runs().get(0).directory()
                            : plan.runs().size() + " runs in " + plan.base()));
            out.flush();
            progress.ticker = ProgressTicker.start(out, progress::lines);
        }
        return progress;
    }

    /** Returns one line per active run, and one for all. */
    public List<String> lines() {
        List<String> lines = new ArrayList<>();
        List<Snapshot> snapshots = new ArrayList<>();
        double portion = 0;
        double stepsPerSecond = 0;
        for (RunMonitor monitor : monitors) {
            Snapshot now = monitor.snapshot();
            snapshots.add(now);
            if (now.phase() == Phase.RUNNING) {
                stepsPerSecond += now.stepsPerSecond();
                if (lines.size() < MOST_LINES) {
                    lines.add(runLine(monitor.run().number(), now));
                }
            }
            portion += isOver(now.phase()) ? 1 : now.portion();
        }
        if (monitors.size() > 1) {
            lines.add("all runs: " + counts(snapshots) + ", " + QuantityText.percent(portion / monitors.size()) + ", "
                    + QuantityText.rate(stepsPerSecond) + ", " + timeLeft(portion));
        }
        return lines;
    }

    /** Whether this process has finished its work on the run. */
    private static boolean isOver(Phase phase) {
        return phase != Phase.RUNNING && phase != Phase.WAITING;
    }

    /** Returns how many runs are complete, and how many this process will not complete. */
    public static String counts(List<Snapshot> runs) {
        return count(runs, Phase.FINISHED) + count(runs, Phase.ALREADY_FINISHED) + " of " + runs.size() + " done"
                + others(runs, Phase.IN_USE, "in use elsewhere")
                + others(runs, Phase.REFUSED, "refused")
                + others(runs, Phase.FAILED, "failed")
                + others(runs, Phase.STOPPED, "stopped");
    }

    private static String others(List<Snapshot> runs, Phase phase, String state) {
        long count = count(runs, phase);
        return count == 0 ? "" : ", " + count + " " + state;
    }

    private static long count(List<Snapshot> runs, Phase phase) {
        return runs.stream().filter(run -> run.phase() == phase).count();
    }

    private static String runLine(int number, Snapshot now) {
        String scores = Double.isNaN(now.best())
                ? "first generation"
                : "best " + Numbers.score(now.best()) + ", median " + Numbers.score(now.median());
        // The part that may exceed 80 columns comes last.
        return "run " + number + ": generation " + now.generation() + "/" + now.generations() + ", " + scores + ", "
                + (now.timeLeft() == null ? "" : QuantityText.duration(now.timeLeft()) + " left, ")
                + QuantityText.rate(now.stepsPerSecond());
    }

    private String timeLeft(double portion) {
        if (Double.isNaN(portionAtStart)) {
            // The progress of earlier sessions is known after the active runs have started.
            portionAtStart = portion;
            startNanos = System.nanoTime();
        }
        double gained = portion - portionAtStart;
        if (gained <= 0) {
            return "time left not known yet";
        }
        double seconds = (System.nanoTime() - startNanos) * 1e-9;
        return "about "
                + QuantityText.duration(
                        Duration.ofMillis((long) (seconds * 1000 * (monitors.size() - portion) / gained)))
                + " left";
    }

    /** Stops showing progress. */
    public void close() {
        if (ticker != null) {
            ticker.close();
        }
    }
}
