package mmneat.experiment.store;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.stream.Stream;
import mmneat.experiment.UserError;

/**
 * The folder of one run, through which all its files are written. They always belong to a complete generation.
 *
 * <p>Files ({@link #write}) and rows of logs ({@link #append}) are held in memory and written together ({@link
 * #flush}), just before the checkpoint that records the lengths of the logs. After a crash the logs are cut back to the
 * lengths in the checkpoint ({@link #cutTo}), and later generations are evolved again.
 *
 * <p>Files are not synced to the disk before {@link #sync}, because syncing file by file can take longer than a
 * generation itself. Until then {@link #unsynced} records by checksums what a failure of the machine may lose.
 *
 * <p>Names are relative to the folder, with {@code /} between the parts, for example {@code bestPacMan/score.txt};
 * those of the logs and score files start with {@link #prefix()}. Texts are written in UTF-8.
 *
 * <p>A file that cannot be written (the disk is full, the folder was deleted) causes an {@link UncheckedIOException}.
 */
public final class RunFolder {

    private final Path directory;
    private final String prefix;
    /** Text to append, by the name of the log. */
    private final Map<String, StringBuilder> held = new TreeMap<>();

    /** Contents of files to write, by name, in the order in which they were first given. */
    private final Map<String, Supplier<byte[]>> heldFiles = new LinkedHashMap<>();

    private final Map<String, Long> lengths = new TreeMap<>();

    private final UnsyncedFiles unsynced;

    /** Files that a continued run writes again from the checkpoint. They are synced when the run is complete. */
    private final Set<Path> derived = new TreeSet<>();

    /**
     * @param directory the run's folder
     * @param prefix prefix of the names of score files and logs: {@code <log><run>_}
     */
    public RunFolder(Path directory, String prefix) {
        this.directory = directory;
        this.prefix = prefix;
        unsynced = new UnsyncedFiles(directory);
    }

    /** The run's folder. */
    public Path directory() {
        return directory;
    }

    /** Prefix of the names of score files and logs, such as {@code blended-2M0_}. */
    public String prefix() {
        return prefix;
    }

    /** Writes a file at the next {@link #flush}, replacing it if it exists. */
    public void write(String name, String content) {
        write(name, content.getBytes(StandardCharsets.UTF_8));
    }

    /** Writes a file at the next {@link #flush}, replacing it if it exists. */
    public void write(String name, byte[] content) {
        write(name, () -> content);
    }

    /**
     * Writes a file at the next {@link #flush}, replacing it if it exists. A file that is written several times before
     * that is made once, with its last content.
     *
     * @param content produces the content, for example from an immutable genotype
     */
    public void write(String name, Supplier<byte[]> content) {
        heldFiles.put(name, content);
    }

    /**
     * Writes a file at once, not at the next {@link #flush}, replacing it if it exists. The content must be computable
     * from the checkpoint alone: {@link #unsynced} does not record the file, so a continued run has to write it again.
     */
    public void writeDerived(String name, String content) {
        replace(name, content.getBytes(StandardCharsets.UTF_8));
        derived.add(directory.resolve(name));
    }

    private void replace(String name, byte[] content) {
        try {
            DurableFiles.replace(directory.resolve(name), content);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Appends text to a log. The next {@link #flush} writes it to the file. */
    public void append(String name, String text) {
        held.computeIfAbsent(name, key -> new StringBuilder()).append(text);
    }

    /** Returns the names of the subfolders, in no particular order. */
    public List<String> folders() {
        try (Stream<Path> entries = Files.list(directory)) {
            return entries.filter(entry -> Files.isDirectory(entry, LinkOption.NOFOLLOW_LINKS))
                    .map(folder -> folder.getFileName().toString())
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Deletes a subfolder with its files, if it exists. */
    public void deleteFolder(String name) {
        heldFiles.keySet().removeIf(file -> file.startsWith(name + "/"));
        Path folder = directory.resolve(name);
        if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
            return;
        }
        try (Stream<Path> entries = Files.walk(folder)) {
            List<Path> innermostFirst =
                    entries.sorted(Comparator.reverseOrder()).toList();
            for (Path entry : innermostFirst) {
                Files.delete(entry);
                derived.remove(entry);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        unsynced.deletedFolder(name);
    }

    /**
     * Writes all files and all appended text of logs that are held in memory.
     *
     * @return the length in bytes of every log, for {@link #cutTo}
     */
    public Map<String, Long> flush() {
        heldFiles.forEach((name, content) -> {
            byte[] bytes = content.get();
            replace(name, bytes);
            unsynced.replaced(name, bytes);
        });
        heldFiles.clear();
        held.forEach((name, text) -> {
            byte[] content = text.toString().getBytes(StandardCharsets.UTF_8);
            long length = lengths.getOrDefault(name, 0L);
            try {
                // A log unknown to the checkpoint was left by a crash: it is overwritten.
                DurableFiles.appendAt(directory.resolve(name), length, content);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
            unsynced.appended(name, length, content);
            lengths.put(name, length + content.length);
        });
        held.clear();
        return Map.copyOf(lengths);
    }

    /**
     * Returns what may not be on the disk yet, except files that can be made again. It changes with every call that
     * writes.
     */
    public UnsyncedFiles unsynced() {
        return unsynced;
    }

    /** Syncs everything that cannot be made again from a checkpoint. */
    public void sync() {
        try {
            unsynced.sync();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Syncs everything. */
    public void syncAll() {
        sync();
        try {
            DurableFiles.sync(derived);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        derived.clear();
    }

    /**
     * Truncates the logs to these lengths, which {@link #flush} returned.
     *
     * @throws UserError if a log is shorter
     */
    public void cutTo(Map<String, Long> checkpointLengths) {
        held.clear();
        heldFiles.clear();
        lengths.clear();
        lengths.putAll(checkpointLengths);
        lengths.forEach((name, length) -> {
            Path file = directory.resolve(name);
            try {
                long there = Files.exists(file) ? Files.size(file) : 0;
                if (there < length) {
                    throw new UserError(file + ": has " + there + " bytes, but the checkpoint was written when it had "
                            + length + "; restore the file, or delete " + directory + " to start the run again");
                }
                DurableFiles.appendAt(file, length, new byte[0]);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        });
    }
}
