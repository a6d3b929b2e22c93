package mmneat.experiment.store;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import mmneat.evolution.DaemonThreads;
import mmneat.experiment.TextFiles;
import org.jspecify.annotations.Nullable;

/**
 * The lock of a run's folder, which allows one process at a time to work in it. Take it with {@link #acquire} and
 * release it with {@link #close}.
 *
 * <p>The lock is a file, {@code lock.json}, that names its holder. It works on shared file systems without advisory
 * locking: it only requires that creating a file fails if the file exists. The holder touches the file every few
 * seconds; the time of the last touch is its sign of life.
 *
 * <p>A lock is dead, and can be taken over, in two cases: its holder ran on this machine and no longer runs; or its
 * holder is on another machine, and its sign of life is old and does not change while it is watched. Watching makes
 * differing clocks harmless. A holder whose lock was taken over detects this before it writes again ({@link
 * #requireHeld}).
 */
public final class RunLock implements AutoCloseable {

    /**
     * The time limits of the lock.
     *
     * @param touch time between two signs of life
     * @param silence age of a sign of life above which the holder may be dead
     * @param watch how long an old sign of life is watched for a change; longer than {@code touch}
     */
    public record Timing(Duration touch, Duration silence, Duration watch) {
        public static final Timing USUAL =
                new Timing(Duration.ofSeconds(5), Duration.ofSeconds(60), Duration.ofSeconds(15));
    }

    /** Thrown when the folder is locked by another process. */
    public static final class HeldException extends Exception {
        private static final long serialVersionUID = 1;

        private HeldException(String message) {
            super(message);
        }

        static HeldException by(String holder, Path lock) {
            return new HeldException(lock.getParent() + " is in use by " + holder
                    + "; wait for it or stop it (the lock is " + lock + ")");
        }

        static HeldException byNobody(Path lock) {
            return new HeldException(
                    lock + " was deleted during the run, so another process may have started the same run;"
                            + " to continue, give the same command again");
        }
    }

    /**
     * The lock file as another process reads it.
     *
     * @param holder empty if the file is incomplete: it is just being written, or its writer died
     * @param signOfLife when the file was last touched
     */
    record Sighting(Optional<LockHolder> holder, Instant signOfLife) {

        /** Whether the holder seems to be alive: it runs on this machine, or its sign of life is recent. */
        boolean seemsAlive(Instant now, Timing timing) {
            return holder.filter(who -> who.isOn(LockHolder.self()))
                    .map(LockHolder::isRunning)
                    .orElse(Duration.between(signOfLife, now).abs().compareTo(timing.silence()) < 0);
        }

        String describe() {
            return holder.map(LockHolder::describe).orElse("an unknown process");
        }
    }

    private static final ObjectMapper JSON = JsonMapper.builder().build();

    private final Path file;
    private final LockHolder self;
    private final ScheduledExecutorService heart;

    /** The failure of the last touch that failed; null if none failed. */
    private volatile @Nullable IOException touchFailure;

    private RunLock(Path file, LockHolder self, Timing timing) {
        this.file = file;
        this.self = self;
        heart = Executors.newSingleThreadScheduledExecutor(DaemonThreads.named("lock of " + file.getParent()));
        long period = timing.touch().toMillis();
        heart.scheduleAtFixedRate(this::touch, period, period, TimeUnit.MILLISECONDS);
    }

    /** Takes the lock of a run's folder, which must exist. */
    public static RunLock acquire(Path directory, Timing timing)
            throws IOException, HeldException, InterruptedException {
        Path file = file(directory);
        LockHolder self = LockHolder.self();
        while (!create(file, self)) {
            Optional<Sighting> sighting = look(directory);
            if (sighting.isPresent()) {
                if (!isDead(directory, sighting.get(), self, timing)) {
                    throw HeldException.by(sighting.get().describe(), file);
                }
                remove(file, sighting.get(), self);
            }
        }
        return new RunLock(file, self, timing);
    }

    /** Reads the lock of a folder; empty if the folder is not locked. */
    static Optional<Sighting> look(Path directory) throws IOException {
        Path file = file(directory);
        OrdinaryFiles.require(file);
        try {
            Instant signOfLife = Files.getLastModifiedTime(file).toInstant();
            return Optional.of(new Sighting(read(file), signOfLife));
        } catch (NoSuchFileException e) {
            return Optional.empty();
        }
    }

    /**
     * Checks that the lock was not taken over.
     *
     * @throws HeldException if it was
     */
    public void requireHeld() throws IOException, HeldException {
        Optional<Sighting> sighting = look(Objects.requireNonNull(file.getParent()));
        boolean held =
                sighting.flatMap(Sighting::holder).filter(self::equalsToken).isPresent();
        if (!held) {
            HeldException lost = sighting.map(other -> HeldException.by(other.describe(), file))
                    .orElseGet(() -> HeldException.byNobody(file));
            if (touchFailure != null) {
                lost.addSuppressed(touchFailure);
            }
            throw lost;
        }
    }

    /** Releases the lock. */
    @Override
    public void close() throws IOException {
        heart.shutdownNow();
        if (read(file).filter(self::equalsToken).isPresent()) {
            Files.deleteIfExists(file);
        }
    }

    private static Path file(Path directory) {
        return directory.toAbsolutePath().normalize().resolve(RunLayout.LOCK);
    }

    private static boolean create(Path file, LockHolder self) throws IOException {
        byte[] json = json(self);
        return create(file, content -> content.write(json));
    }

    /** Writes the content of a lock's file; may fail. */
    interface Content {
        void writeTo(OutputStream file) throws IOException;
    }

    /**
     * Creates the file with this content, unless it exists.
     *
     * @return false if the file exists
     */
    static boolean create(Path file, Content content) throws IOException {
        OutputStream created;
        try {
            created = Files.newOutputStream(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
        } catch (FileAlreadyExistsException e) {
            return false;
        }
        try (created) {
            content.writeTo(created);
            return true;
        } catch (IOException e) {
            // A full disk may have room for the name only. A lock without a holder would lock the run forever.
            try {
                Files.deleteIfExists(file);
            } catch (IOException second) {
                e.addSuppressed(second);
            }
            throw e;
        }
    }

    private static boolean isDead(Path directory, Sighting sighting, LockHolder self, Timing timing)
            throws IOException, InterruptedException {
        if (sighting.seemsAlive(Instant.now(), timing)) {
            return false;
        }
        if (sighting.holder().filter(self::isOn).isPresent()) {
            return true;
        }
        long end = System.nanoTime() + timing.watch().toNanos();
        while (System.nanoTime() < end) {
            Optional<Sighting> now = look(directory);
            if (now.isEmpty()) {
                return true;
            }
            if (!now.get().equals(sighting)) {
                return false;
            }
            TimeUnit.MILLISECONDS.sleep(Math.max(1, timing.touch().toMillis() / 5));
        }
        return true;
    }

    /**
     * Removes a dead lock. If two processes find the same lock dead, the slower one may move the new lock of the faster
     * one; it then moves it back.
     */
    private static void remove(Path file, Sighting dead, LockHolder self) throws IOException {
        Path aside = file.resolveSibling("lock-" + self.token() + ".dead");
        try {
            Files.move(file, aside, StandardCopyOption.ATOMIC_MOVE);
        } catch (NoSuchFileException e) {
            return;
        }
        Optional<LockHolder> moved = read(aside);
        if (moved.isPresent() && !moved.equals(dead.holder())) {
            create(file, moved.get());
        }
        Files.delete(aside);
    }

    private static Optional<LockHolder> read(Path file) throws IOException {
        try {
            Map<?, ?> fields = JSON.readValue(TextFiles.bytes(file, TextFiles.SETTINGS_MIB), Map.class);
            if (fields == null) {
                // The JSON text "null".
                return Optional.empty();
            }
            return Optional.of(new LockHolder(
                    String.valueOf(fields.get("host")),
                    String.valueOf(fields.get("machine")),
                    Long.parseLong(String.valueOf(fields.get("pid"))),
                    Instant.parse(String.valueOf(fields.get("processStart"))),
                    Instant.parse(String.valueOf(fields.get("since"))),
                    String.valueOf(fields.get("token"))));
        } catch (NoSuchFileException
                | JsonProcessingException
                | IllegalArgumentException
                | java.time.DateTimeException e) {
            // The file is just being written, or its writer died: only its age can decide.
            return Optional.empty();
        }
    }

    private static byte[] json(LockHolder holder) throws IOException {
        Map<String, Object> fields = new java.util.LinkedHashMap<>();
        fields.put("host", holder.host());
        fields.put("pid", holder.pid());
        fields.put("since", holder.since().toString());
        fields.put("processStart", holder.processStart().toString());
        fields.put("machine", holder.machine());
        fields.put("token", holder.token());
        return JSON.writerWithDefaultPrettyPrinter().writeValueAsBytes(fields);
    }

    private void touch() {
        try {
            // The lock of another process must keep its time of last touch.
            if (read(file).filter(self::equalsToken).isPresent()) {
                Files.setLastModifiedTime(file, FileTime.from(Instant.now()));
            }
        } catch (IOException e) {
            // The lock is gone or the file system is temporarily unavailable: requireHeld detects it before each write.
            touchFailure = e;
        }
    }
}
