package mmneat.experiment.run;

import java.time.Duration;
import java.util.function.LongSupplier;

/**
 * When a run waits until its files are on the disk. A failure of the machine then costs little work, all of which is done again
 * with the same result; a failure of the program alone costs nothing in between either.
 */
final class SyncSchedule {

    /** About what the failure of a machine may cost. */
    private static final Duration LONGEST = Duration.ofSeconds(30);

    /** Checkpoints tell of every file that was not synced, and should stay small beside a population. */
    private static final int MOST_FILES = 500;

    private final LongSupplier nanoTime;
    private boolean isFirst = true;
    private long lastNanos;

    SyncSchedule(LongSupplier nanoTime) {
        this.nanoTime = nanoTime;
    }

    /** Whether it is time, with so many files that may not be on the disk. The first time it always is. */
    boolean isDue(int unsyncedFiles) {
        return isFirst || unsyncedFiles >= MOST_FILES || nanoTime.getAsLong() - lastNanos >= LONGEST.toNanos();
    }

    /** Notes that everything is on the disk. */
    void done() {
        isFirst = false;
        lastNanos = nanoTime.getAsLong();
    }
}
