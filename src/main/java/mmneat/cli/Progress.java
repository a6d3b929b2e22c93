package mmneat.cli;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import mmneat.analysis.statistics.Numbers;
import mmneat.evolution.DaemonThreads;
import mmneat.experiment.run.ExperimentPlan;
import mmneat.experiment.run.RunMonitor;
import mmneat.experiment.run.RunMonitor.Phase;
import mmneat.experiment.run.RunMonitor.Snapshot;
import picocli.CommandLine.Help.Ansi;

/**
 * Shows how an experiment goes while it does. On a terminal a line for each run at work and one for all, kept up to date; in a
 * log file or on a dumb terminal the same lines now and then, ever more rarely.
 */
final class Progress {

    /** On a terminal more runs at work than this are not shown one by one. */
    private static final int MOST_LINES = 16;

    private static final long TERMINAL_MILLIS = 500;
    private static final Duration FIRST_PLAIN = Duration.ofSeconds(10);
    private static final Duration LAST_PLAIN = Duration.ofMinutes(10);

    private static final String UP_AND_CLEAR = "\u001b[1A\u001b[2K";

    /** A line that is longer than the terminal is wide must not go on in the next: it could not be taken back line by line. */
    private static final String WITHOUT_WRAPPING = "\u001b[?7l";

    private static final String WRAPPING_AGAIN = "\u001b[?7h";

    private final PrintWriter out;
    private final List<RunMonitor> monitors;
    private final boolean isTerminal;
    private final ScheduledExecutorService clock =
            Executors.newSingleThreadScheduledExecutor(DaemonThreads.named("progress"));

    private double portionAtStart = Double.NaN;
    private long startNanos;
    private int linesOnTerminal;
    private boolean isClosed;

    private Progress(PrintWriter out, List<RunMonitor> monitors, boolean isTerminal) {
        this.out = out;
        this.monitors = monitors;
        this.isTerminal = isTerminal;
    }

    /** Begins to show progress, unless it is to be quiet. */
    static Progress start(boolean quiet, PrintWriter out, ExperimentPlan plan, List<RunMonitor> monitors) {
        Progress progress = new Progress(out, monitors, Ansi.AUTO.enabled());
        if (!quiet) {
            out.println(plan.name() + ": "
                    + (plan.runs().size() == 1
                            ? "run " + plan.runs().get(0).number() + " in "
                                    + plan.runs().get(0).directory()
                            : plan.runs().size() + " runs in " + plan.base()));
            out.flush();
            progress.begin();
        }
        return progress;
    }

    private void begin() {
        if (isTerminal) {
            clock.scheduleAtFixedRate(this::redraw, TERMINAL_MILLIS, TERMINAL_MILLIS, TimeUnit.MILLISECONDS);
        } else {
            scheduleNote(FIRST_PLAIN);
        }
    }

    private void scheduleNote(Duration after) {
        Duration next = after.multipliedBy(2);
        clock.schedule(
                () -> {
                    lines().forEach(out::println);
                    out.flush();
                    scheduleNote(next.compareTo(LAST_PLAIN) < 0 ? next : LAST_PLAIN);
                },
                after.toMillis(),
                TimeUnit.MILLISECONDS);
    }

    private synchronized void redraw() {
        if (isClosed) {
            return;
        }
        List<String> lines = lines();
        out.print(UP_AND_CLEAR.repeat(linesOnTerminal) + WITHOUT_WRAPPING);
        lines.forEach(out::println);
        out.print(WRAPPING_AGAIN);
        out.flush();
        linesOnTerminal = lines.size();
    }

    /** A line for each run at work, and one for all. */
    List<String> lines() {
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
            lines.add("all runs: " + counts(snapshots) + ", " + Texts.percent(portion / monitors.size()) + ", "
                    + Texts.rate(stepsPerSecond) + ", " + timeLeft(portion));
        }
        return lines;
    }

    /** Whether this process has nothing more to do for the run. */
    private static boolean isOver(Phase phase) {
        return phase != Phase.RUNNING && phase != Phase.WAITING;
    }

    /** How many runs are done, and how many never will be by this process. */
    static String counts(List<Snapshot> runs) {
        return count(runs, Phase.FINISHED) + count(runs, Phase.ALREADY_FINISHED) + " of " + runs.size() + " done"
                + others(runs, Phase.IN_USE, "in use elsewhere")
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
        // What may not fit into 80 columns stands last.
        return "run " + number + ": generation " + now.generation() + "/" + now.generations() + ", " + scores + ", "
                + (now.timeLeft() == null ? "" : Texts.duration(now.timeLeft()) + " left, ")
                + Texts.rate(now.stepsPerSecond());
    }

    private String timeLeft(double portion) {
        if (Double.isNaN(portionAtStart)) {
            // What earlier sessions did is known after the runs at work have begun.
            portionAtStart = portion;
            startNanos = System.nanoTime();
        }
        double gained = portion - portionAtStart;
        if (gained <= 0) {
            return "time left not known yet";
        }
        double seconds = (System.nanoTime() - startNanos) * 1e-9;
        return "about "
                + Texts.duration(Duration.ofMillis((long) (seconds * 1000 * (monitors.size() - portion) / gained)))
                + " left";
    }

    /** Stops showing progress; nothing is taken back on the terminal afterwards. */
    synchronized void close() {
        if (isClosed) {
            return;
        }
        isClosed = true;
        clock.shutdownNow();
        out.print(UP_AND_CLEAR.repeat(linesOnTerminal));
        out.flush();
    }
}
