package mmneat.experiment.run;

import java.time.Duration;
import java.util.function.LongSupplier;

/** The progress of one run: written by the run's thread, read by any thread. */
public final class RunMonitor {

    /** What a run is doing. */
    public enum Phase {
        WAITING,
        RUNNING,
        FINISHED,
        ALREADY_FINISHED,
        IN_USE,
        /** Its folder cannot be continued in, and nothing in it was changed. */
        REFUSED,
        FAILED,
        STOPPED
    }

    /**
     * One moment of a run.
     *
     * @param phase what the run is doing
     * @param generation number of the generation at work; the number of all generations when they are done
     * @param generations generations that are asked for
     * @param best score of the champion of the last complete generation; NaN before the first
     * @param median median score of that generation's parents; NaN before the first
     * @param stepsPerSecond simulated time steps per second
     * @param portion what portion of all the evaluations of the run is done, in [0, 1]
     * @param timeLeft estimate of the time to the end; null before anything can be said
     */
    public record Snapshot(
            Phase phase,
            int generation,
            int generations,
            double best,
            double median,
            double stepsPerSecond,
            double portion,
            Duration timeLeft) {}

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

    /** The run that is watched. */
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

    /** Seconds that this process has worked at the run. */
    synchronized double seconds() {
        return phase == Phase.WAITING ? 0 : (nanoTime.getAsLong() - startNanos) * 1e-9;
    }

    synchronized double stepsPerSecond() {
        double seconds = seconds();
        return seconds > 0 ? steps / seconds : 0;
    }

    /** How the run goes now. */
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
