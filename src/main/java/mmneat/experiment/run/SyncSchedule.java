package mmneat.experiment.run;

import java.time.Duration;
import java.util.function.LongSupplier;

/**
 * The schedule by which a run syncs its files to the disk: at its first checkpoint in this process, and then at a
 * checkpoint 30 s or more after the last sync, or once 500 files are unsynced.
 *
 * <p>After a failure of the machine (power, operating system), the work since the last sync is done again with the same
 * result. If only the program crashes, no written file is lost, synced or not.
 */
final class SyncSchedule {

    /** Approximate limit of the work that a failure of the machine may cost. */
    private static final Duration LONGEST = Duration.ofSeconds(30);

    /**
     * Maximum number of unsynced files. Checkpoints record each, and the record should be small compared with a
     * population.
     */
    private static final int MOST_FILES = 500;

    private final LongSupplier nanoTime;
    private boolean isFirst = true;
    private long lastNanos;

    SyncSchedule(LongSupplier nanoTime) {
        this.nanoTime = nanoTime;
    }

    /** Whether a sync is due, given the number of unsynced files. The first time it is always due. */
    boolean isDue(int unsyncedFiles) {
        return isFirst || unsyncedFiles >= MOST_FILES || nanoTime.getAsLong() - lastNanos >= LONGEST.toNanos();
    }

    /** Records that all files were synced. */
    void done() {
        isFirst = false;
        lastNanos = nanoTime.getAsLong();
    }
}
