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
 * The process that holds a lock.
 *
 * @param host name of the computer
 * @param machine identity of the running system and its process numbers. Processes with the same identity can see each
 *     other. It differs between boots and between containers
 * @param pid process id
 * @param processStart when the process was started, to distinguish it from a later process with the same id
 * @param since when the lock was taken
 * @param token unique to this lock
 */
record LockHolder(String host, String machine, long pid, Instant processStart, Instant since, String token) {

    /** The start time reported by the operating system may vary by rounding. */
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

    /** Whether both processes run on the same machine, so that one can see the other. */
    boolean isOn(LockHolder other) {
        return machine.equals(other.machine);
    }

    /** Whether both are the same lock. */
    boolean equalsToken(LockHolder other) {
        return token.equals(other.token);
    }

    /** Whether the process still runs. Call it only if {@link #isOn} is true. */
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

    /** Returns a description for messages. */
    String describe() {
        return "process " + pid + " on " + host + ", since " + since.truncatedTo(java.time.temporal.ChronoUnit.SECONDS);
    }

    private static String hostName() {
        try {
            return InetAddress.getLocalHost().getHostName();
        } catch (UnknownHostException e) {
            // The host name is unknown; the identity below still distinguishes the machine from others.
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
            // Not Linux: the host name is used.
            return "-";
        }
    }

    private static String processNamespace() {
        try {
            return Files.readSymbolicLink(Path.of("/proc/self/ns/pid")).toString();
        } catch (IOException | UnsupportedOperationException e) {
            // Not Linux: there are no separate process namespaces.
            return "-";
        }
    }
}
