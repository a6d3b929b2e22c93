package mmneat.experiment.store;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RunLockTest {

    private static final RunLock.Timing QUICK =
            new RunLock.Timing(Duration.ofMillis(10), Duration.ofMillis(500), Duration.ofMillis(60));

    @TempDir
    Path folder;

    @Test
    void secondHolder_isRefused_andTheMessageNamesTheFirst() throws Exception {
        try (RunLock first = RunLock.acquire(folder, QUICK)) {
            first.requireHeld();
            assertThatThrownBy(() -> RunLock.acquire(folder, QUICK))
                    .isInstanceOf(RunLock.HeldException.class)
                    .hasMessageContaining("process " + ProcessHandle.current().pid())
                    .hasMessageContaining(folder.toString());
            first.requireHeld();
        }
        assertThat(folder).isEmptyDirectory();
        RunLock.acquire(folder, QUICK).close();
    }

    @Test
    void lockOfADeadProcessOnThisMachine_isTakenOverAtOnce() throws Exception {
        Process process = new ProcessBuilder("true").start();
        long pid = process.pid();
        process.waitFor();
        writeLock(LockHolder.self().machine(), pid, Instant.now());
        RunLock.Timing patient = new RunLock.Timing(Duration.ofDays(1), Duration.ofDays(1), Duration.ofDays(1));
        try (RunLock lock = RunLock.acquire(folder, patient)) {
            lock.requireHeld();
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void lockOfALaterProcessWithTheSameNumber_isTakenOver() throws Exception {
        writeLock(LockHolder.self().machine(), ProcessHandle.current().pid(), Instant.EPOCH);
        RunLock.acquire(folder, QUICK).close();
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void lockOfAnotherMachine_recentlyTouched_isRespected() throws IOException {
        writeLock("elsewhere", 1, Instant.now());
        assertThatThrownBy(() -> RunLock.acquire(folder, RunLock.Timing.USUAL))
                .isInstanceOf(RunLock.HeldException.class)
                .hasMessageContaining("process 1 on far");
    }

    @Test
    void lockOfAnotherMachine_silentWhileWatched_isTakenOver() throws Exception {
        Path lock = writeLock("elsewhere", 1, Instant.now());
        for (Duration age : List.of(Duration.ofHours(1), Duration.ofHours(-1))) {
            // A clock that is wrong by an hour in either direction must not prevent that a dead lock is taken over.
            writeLock("elsewhere", 1, Instant.now());
            Files.setLastModifiedTime(lock, FileTime.from(Instant.now().minus(age)));
            RunLock.acquire(folder, QUICK).close();
        }
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void lockOfAnotherMachineWithAWrongClock_thatIsTouchedWhileWatched_isRespected() throws Exception {
        Path lock = writeLock("elsewhere", 1, Instant.now());
        Instant past = Instant.now().minus(Duration.ofHours(2));
        Files.setLastModifiedTime(lock, FileTime.from(past));
        RunLock.Timing longWatch =
                new RunLock.Timing(Duration.ofMillis(5), Duration.ofMillis(500), Duration.ofMinutes(5));
        ExecutorService other = Executors.newSingleThreadExecutor();
        CountDownLatch stop = new CountDownLatch(1);
        Future<?> touching = other.submit(() -> {
            long beats = 0;
            while (stop.getCount() > 0) {
                Files.setLastModifiedTime(lock, FileTime.from(past.plusSeconds(++beats)));
            }
            return null;
        });
        try {
            assertThatThrownBy(() -> RunLock.acquire(folder, longWatch)).isInstanceOf(RunLock.HeldException.class);
        } finally {
            stop.countDown();
            touching.get();
            other.shutdown();
        }
    }

    @Test
    void unreadableLock_isJudgedByItsAge() throws Exception {
        Path lock = folder.resolve("lock.json");
        Files.writeString(lock, "{\"host");
        assertThatThrownBy(() -> RunLock.acquire(folder, RunLock.Timing.USUAL))
                .isInstanceOf(RunLock.HeldException.class)
                .hasMessageContaining("an unknown process");
        Files.setLastModifiedTime(lock, FileTime.from(Instant.now().minusSeconds(3600)));
        RunLock.acquire(folder, QUICK).close();
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void holderWhoseLockWasTakenOver_detectsIt_andKeepsTheNewLock() throws Exception {
        RunLock slept = RunLock.acquire(folder, QUICK);
        writeLock("elsewhere", 7, Instant.now());
        assertThatThrownBy(slept::requireHeld)
                .isInstanceOf(RunLock.HeldException.class)
                .hasMessageContaining("process 7 on far");
        slept.close();
        assertThat(folder.resolve("lock.json")).exists();
    }

    @Test
    void lockOfAnother_isNotTouchedByItsFormerHolder() throws Exception {
        try (RunLock slept = RunLock.acquire(folder, QUICK)) {
            Path lock = writeLock("elsewhere", 7, Instant.now());
            FileTime old = FileTime.from(Instant.EPOCH);
            Files.setLastModifiedTime(lock, old);
            // Twenty heartbeats.
            Thread.sleep(QUICK.touch().toMillis() * 20);
            assertThat(Files.getLastModifiedTime(lock)).isEqualTo(old);
            assertThatThrownBy(slept::requireHeld).isInstanceOf(RunLock.HeldException.class);
        }
    }

    @Test
    void lockThatCannotBeWritten_leavesNoFileBehind() throws Exception {
        Path lock = folder.resolve("lock.json");
        assertThatThrownBy(() -> RunLock.create(lock, file -> {
                    throw new IOException("No space left on device");
                }))
                .isInstanceOf(IOException.class)
                .hasMessage("No space left on device");
        assertThat(folder).isEmptyDirectory();
        RunLock.acquire(folder, RunLock.Timing.USUAL).close();
    }

    @Test
    void holderWhoseLockWasDeleted_detectsIt() throws Exception {
        try (RunLock lock = RunLock.acquire(folder, QUICK)) {
            Files.delete(folder.resolve("lock.json"));
            assertThatThrownBy(lock::requireHeld)
                    .isInstanceOf(RunLock.HeldException.class)
                    .hasMessageStartingWith(folder.resolve("lock.json") + " was deleted");
        }
    }

    @Test
    void holder_givesSignsOfLife() throws Exception {
        try (RunLock lock = RunLock.acquire(folder, QUICK)) {
            Path file = folder.resolve("lock.json");
            FileTime old = FileTime.from(Instant.EPOCH);
            Files.setLastModifiedTime(file, old);
            while (Files.getLastModifiedTime(file).equals(old)) {
                Thread.onSpinWait();
            }
            lock.requireHeld();
        }
    }

    @Test
    void manyAtOnce_exactlyOneTakesOverADeadLock() throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(8);
        for (int round = 0; round < 20; round++) {
            writeLock(LockHolder.self().machine(), ProcessHandle.current().pid(), Instant.EPOCH);
            CountDownLatch start = new CountDownLatch(1);
            List<Future<RunLock>> attempts = new ArrayList<>();
            for (int i = 0; i < 8; i++) {
                attempts.add(threads.submit(() -> {
                    start.await();
                    try {
                        return RunLock.acquire(folder, QUICK);
                    } catch (RunLock.HeldException e) {
                        return null;
                    }
                }));
            }
            start.countDown();
            List<RunLock> locks = new ArrayList<>();
            for (Future<RunLock> attempt : attempts) {
                if (attempt.get() != null) {
                    locks.add(attempt.get());
                }
            }
            int holding = 0;
            for (RunLock lock : locks) {
                holding += holds(lock) ? 1 : 0;
            }
            for (RunLock lock : locks) {
                lock.close();
            }
            assertThat(holding).isEqualTo(1);
            Files.deleteIfExists(folder.resolve("lock.json"));
        }
        threads.shutdown();
    }

    private static boolean holds(RunLock lock) throws IOException {
        try {
            lock.requireHeld();
            return true;
        } catch (RunLock.HeldException e) {
            return false;
        }
    }

    private Path writeLock(String machine, long pid, Instant processStart) throws IOException {
        Path lock = folder.resolve("lock.json");
        Files.writeString(lock, """
                {"host": "far", "pid": %d, "since": "2026-01-01T00:00:00Z", "processStart": "%s", "machine": "%s",
                 "token": "another"}
                """.formatted(pid, processStart, machine));
        return lock;
    }
}
