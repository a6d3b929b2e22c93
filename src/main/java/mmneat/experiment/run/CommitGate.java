package mmneat.experiment.run;

import java.time.Duration;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantReadWriteLock;

/**
 * A gate that runs pass to write a generation, any number at a time, until it is closed. Once it is closed, nothing is being
 * written and nothing will be, so that the program can end.
 */
final class CommitGate {

    private final ReentrantReadWriteLock lock = new ReentrantReadWriteLock();
    private boolean closed;

    /** Something that writes. */
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
     * Waits until no run writes, and closes.
     *
     * @return false if a run still wrote when the time was over; the gate is then open
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
