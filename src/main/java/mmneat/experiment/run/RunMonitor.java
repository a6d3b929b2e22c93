package mmneat.experiment.run;

import java.time.Duration;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;

/** The progress of one run. The run's thread writes it; any thread can read it. */
public final class RunMonitor {

    /**
     * The phase of a run within this execution of the program: from waiting for a thread to its end. Other programs see
     * {@link mmneat.experiment.store.RunView.State}, which is read from files.
     */
    public enum Phase {
        /** No thread has started it yet. */
        WAITING,
        /** It is evolving. */
        RUNNING,
        /** It was completed now. */
        FINISHED,
        /** It had been completed before. Nothing was done. */
        ALREADY_FINISHED,
        /** Another process holds the lock of its folder. Nothing was done. */
        IN_USE,
        /**
         * The check before the start found an error of the user: the run cannot be started or continued in its folder
         * with these parameters. Nothing in the folder was changed.
         */
        REFUSED,
        /** An exception ended it after it had started. Its folder records why. */
        FAILED,
        /** The program was interrupted. The same command continues the run. */
        STOPPED
    }

    /**
     * The progress of a run at one moment.
     *
     * @param phase the phase
     * @param generation number of the current generation; the number of all generations when they are complete
     * @param generations number of requested generations
     * @param best score of the champion of the last complete generation; NaN before the first
     * @param median median score of that generation's parents; NaN before the first
     * @param stepsPerSecond simulated time steps per second
     * @param portion completed share of all evaluations of the run, in [0, 1]
     * @param timeLeft estimated time to the end; null before an estimate is possible
     */
    public record Snapshot(
            Phase phase,
            int generation,
            int generations,
            double best,
            double median,
            double stepsPerSecond,
            double portion,
            @Nullable Duration timeLeft) {}

    private final RunPlan run;
    private final LongSupplier nanoTime;
    private final long totalEvaluations;
    private final int population;

    private Phase phase = Phase.WAITING;
    private int generation;
    private double best = Double.NaN;
    private double median = Double.NaN;
    private long startNanos;
    private long evaluationsBefore;
    private long evaluations;
    private long steps;

    RunMonitor(RunPlan run, LongSupplier nanoTime) {
        this.run = run;
        this.nanoTime = nanoTime;
        population = run.parameters().integer("mu");
        totalEvaluations = evaluationsUpTo(run.generations()) + population;
    }

    private long evaluationsUpTo(int generations) {
        return 2L * population * generations;
    }

    /** The monitored run. */
    public RunPlan run() {
        return run;
    }

    synchronized void started(int firstGeneration) {
        phase = Phase.RUNNING;
        generation = firstGeneration;
        startNanos = nanoTime.getAsLong();
        evaluationsBefore = evaluationsUpTo(firstGeneration);
        evaluations = evaluationsBefore;
        steps = 0;
    }

    synchronized void evaluated(long simulatedSteps) {
        evaluations++;
        steps += simulatedSteps;
    }

    synchronized void generationCompleted(int completed, double bestScore, double medianScore) {
        generation = completed;
        best = bestScore;
        median = medianScore;
    }

    synchronized void ended(Phase how) {
        phase = how;
        if (how == Phase.ALREADY_FINISHED) {
            generation = run.generations();
            evaluations = totalEvaluations;
            evaluationsBefore = totalEvaluations;
        }
    }

    /** Seconds that this process has worked on the run. */
    synchronized double seconds() {
        return phase == Phase.WAITING ? 0 : (nanoTime.getAsLong() - startNanos) * 1e-9;
    }

    synchronized double stepsPerSecond() {
        double seconds = seconds();
        return seconds > 0 ? steps / seconds : 0;
    }

    /** Returns the current progress. */
    public synchronized Snapshot snapshot() {
        long done = evaluations - evaluationsBefore;
        Duration timeLeft = null;
        if (phase == Phase.RUNNING && done > 0) {
            timeLeft = Duration.ofMillis((long) (seconds() * 1000 / done * (totalEvaluations - evaluations)));
        } else if (phase != Phase.RUNNING && phase != Phase.WAITING) {
            timeLeft = Duration.ZERO;
        }
        return new Snapshot(
                phase,
                generation,
                run.generations(),
                best,
                median,
                stepsPerSecond(),
                (double) evaluations / totalEvaluations,
                timeLeft);
    }
}
