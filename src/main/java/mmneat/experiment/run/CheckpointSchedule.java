package mmneat.experiment.run;

import java.time.Duration;
import java.util.function.LongSupplier;
import mmneat.experiment.UserError;

/**
 * The schedule of a run's checkpoints: after which generations it writes a checkpoint and all files that are held in
 * memory.
 *
 * <p>By default ({@code checkpointEvery=auto}) a run saves after every generation, but at most once a second: a killed
 * run of fast generations loses at most a second of work, and evolves those generations again with the same result. The
 * first and the last generation are always saved.
 */
final class CheckpointSchedule {

    private static final long SHORTEST_NANOS = Duration.ofSeconds(1).toNanos();

    /** Generations between two checkpoints; 0: by time. */
    private final int generations;

    private final LongSupplier nanoTime;
    private boolean isFirst = true;
    private long lastNanos;

    private CheckpointSchedule(int generations, LongSupplier nanoTime) {
        this.generations = generations;
        this.nanoTime = nanoTime;
    }

    /**
     * Returns the schedule that the parameter {@code checkpointEvery} describes.
     *
     * @param text {@code auto} or a number of generations, at least 1
     * @throws UserError if it is neither
     */
    static CheckpointSchedule of(String text, LongSupplier nanoTime) {
        if (text.equals("auto")) {
            return new CheckpointSchedule(0, nanoTime);
        }
        if (!text.matches("[1-9][0-9]{0,8}")) {
            throw new UserError(
                    "checkpointEvery=" + text + ": must be auto or a whole number of generations, at least 1");
        }
        return new CheckpointSchedule(Integer.parseInt(text), nanoTime);
    }

    /** Whether to save after this number of complete generations. */
    boolean isDue(int completed, boolean isLast) {
        if (isFirst || isLast) {
            return true;
        }
        return generations == 0 ? nanoTime.getAsLong() - lastNanos >= SHORTEST_NANOS : completed % generations == 0;
    }

    /** Records that a checkpoint has just been saved. */
    void done() {
        isFirst = false;
        lastNanos = nanoTime.getAsLong();
    }
}
