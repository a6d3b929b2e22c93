package mmneat.experiment.run;

import java.time.Duration;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantReadWriteLock;

/**
 * A gate that every run passes to write a generation; many runs can be inside at the same time. After it is closed, no
 * run is writing and none will write, so that the program can end.
 */
final class CommitGate {

    private final ReentrantReadWriteLock lock = new ReentrantReadWriteLock();
    private boolean closed;

    /** An action that writes files. */
    interface Commit {
        void run() throws Exception;
    }

    /** @throws CancellationException if the gate is closed */
    void pass(Commit commit) throws Exception {
        lock.readLock().lockInterruptibly();
        try {
            if (closed) {
                throw new CancellationException("stopped");
            }
            commit.run();
        } finally {
            lock.readLock().unlock();
        }
    }

    /**
     * Closes the gate once the current writes are finished.
     *
     * @return false if they were not finished within {@code patience}; the gate then stays open
     */
    boolean close(Duration patience) throws InterruptedException {
        if (!lock.writeLock().tryLock(patience.toMillis(), TimeUnit.MILLISECONDS)) {
            return false;
        }
        try {
            closed = true;
            return true;
        } finally {
            lock.writeLock().unlock();
        }
    }
}
