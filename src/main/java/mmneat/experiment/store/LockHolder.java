package mmneat.experiment.store;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.UUID;

/**
 * Who holds a lock.
 *
 * @param host name of the computer
 * @param machine identity of the running system and its process numbers: two processes with the same one can see each
 *     other; differs between boots and between containers
 * @param pid number of the process
 * @param processStart when the process was started, to tell it from a later one with the same number
 * @param since when the lock was taken
 * @param token unique to this lock
 */
record LockHolder(String host, String machine, long pid, Instant processStart, Instant since, String token) {

    /** The operating system's times of starts may differ by rounding when it is asked again. */
    private static final Duration START_TOLERANCE = Duration.ofSeconds(5);

    /** This process. */
    static LockHolder self() {
        ProcessHandle process = ProcessHandle.current();
        String host = hostName();
        return new LockHolder(
                host,
                machine(host),
                process.pid(),
                process.info().startInstant().orElse(Instant.EPOCH),
                Instant.now(),
                UUID.randomUUID().toString());
    }

    /** Whether the holder is a process that this one can look for. */
    boolean isOn(LockHolder other) {
        return machine.equals(other.machine);
    }

    /** Whether both are the same lock. */
    boolean equalsToken(LockHolder other) {
        return token.equals(other.token);
    }

    /** Whether the process still runs; only asked where {@link #isOn} holds. */
    boolean isRunning() {
        Optional<ProcessHandle> process = ProcessHandle.of(pid).filter(ProcessHandle::isAlive);
        return process.isPresent()
                && process.get()
                        .info()
                        .startInstant()
                        .map(start ->
                                Duration.between(start, processStart).abs().compareTo(START_TOLERANCE) <= 0)
                        .orElse(true);
    }

    /** For messages. */
    String describe() {
        return "process " + pid + " on " + host + ", since " + since.truncatedTo(java.time.temporal.ChronoUnit.SECONDS);
    }

    private static String hostName() {
        try {
            return InetAddress.getLocalHost().getHostName();
        } catch (UnknownHostException e) {
            // The computer does not know itself by name; the identity below still tells it from others.
            return "unknown host";
        }
    }

    private static String machine(String host) {
        return host + " " + systemFile("/proc/sys/kernel/random/boot_id") + " " + processNamespace();
    }

    private static String systemFile(String name) {
        try {
            return Files.readString(Path.of(name)).strip();
        } catch (IOException e) {
            // Not Linux: the host's name has to do.
            return "-";
        }
    }

    private static String processNamespace() {
        try {
            return Files.readSymbolicLink(Path.of("/proc/self/ns/pid")).toString();
        } catch (IOException | UnsupportedOperationException e) {
            // Not Linux: there are no separate numberings of processes to be told apart.
            return "-";
        }
    }
}
