package mmneat.experiment.store;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Stream;
import mmneat.evolution.EvolutionSettings;
import mmneat.experiment.UserError;

/**
 * The check that a run can continue from a checkpoint. The checkpoint must name only files of this run, and its state
 * must be possible in an evolution with these settings.
 */
public final class CheckpointCheck {

    /** Maximum size of everything except the genotypes, in bytes of JSON. */
    private static final long ROOM_FOR_THE_REST = 16L << 20;

    /** Maximum size of a genotype, in bytes of JSON: about ten thousand genes. */
    private static final long ROOM_FOR_A_GENOTYPE = 1L << 20;

    private final EvolutionSettings settings;
    private final String prefix;

    /**
     * Creates the check for one run.
     *
     * @param prefix prefix of the names of its score files and logs
     */
    public CheckpointCheck(EvolutionSettings settings, String prefix) {
        this.settings = settings;
        this.prefix = prefix;
    }

    /**
     * Returns the maximum uncompressed size in bytes. Larger checkpoints are refused, because they may be made to
     * exhaust the memory.
     */
    long maximumBytes() {
        return Math.min(Integer.MAX_VALUE - 16L, ROOM_FOR_THE_REST + ROOM_FOR_A_GENOTYPE * settings.populationSize());
    }

    /**
     * Checks that the run of a folder can continue from a checkpoint.
     *
     * @throws UserError if the checkpoint names a file that is not of this run
     * @throws IllegalArgumentException if it is damaged; the message says what is wrong
     * @throws IOException if a log cannot be read
     */
    void require(Checkpoint checkpoint, Path directory) throws IOException {
        requireNames(checkpoint.logs().keySet(), name -> RunLayout.isLog(prefix, name), directory);
        requireNames(checkpoint.unsynced().keySet(), name -> RunLayout.isWrittenByRun(prefix, name), directory);
        for (Map.Entry<String, Long> log : checkpoint.logs().entrySet()) {
            requireLength(log.getKey(), log.getValue(), directory);
        }
        if (checkpoint.evolution().generation() == 0) {
            requireNoLogs(checkpoint.logs());
        } else {
            requireAllLogs(checkpoint.logs().keySet(), directory);
            requireLastRow(checkpoint, directory);
        }
        checkpoint.unsynced().forEach((name, stretch) -> {
            if (stretch == null || stretch.from() < 0 || stretch.to() < stretch.from()) {
                throw new IllegalArgumentException("unforced: " + name + " has no stretch of bytes");
            }
        });
        checkpoint.evolution().requireReachable(settings);
    }

    private static void requireNames(Collection<String> names, Predicate<String> isKnown, Path directory) {
        names.stream().filter(name -> !isKnown.test(name)).findFirst().ifPresent(name -> {
            throw new UserError(
                    directory + ": its checkpoint names '" + name + "', which is not a file of this run; the folder"
                            + " was changed by hand and is left as it is: restore the checkpoint or give another folder with"
                            + " base=FOLDER");
        });
    }

    private static void requireLength(String log, Long length, Path directory) throws IOException {
        if (length == null || length < 0) {
            throw new IllegalArgumentException("logs: the length of " + log + " must not be negative, is " + length);
        }
        Path file = directory.resolve(log);
        long present = Files.exists(file, LinkOption.NOFOLLOW_LINKS) ? Files.size(file) : 0;
        if (present < length) {
            throw new IllegalArgumentException(
                    log + " has " + present + " bytes, but the checkpoint was written when it had " + length);
        }
    }

    /** Checks that no log was begun before the checkpoint of generation 0 was written. */
    private static void requireNoLogs(Map<String, Long> logs) {
        new TreeMap<>(logs).forEach((log, length) -> {
            if (length > 0) {
                throw new IllegalArgumentException(
                        "generation is 0, but " + log + " had " + length + " bytes when the checkpoint was written");
            }
        });
    }

    /** Checks that the table of generations ends, where the checkpoint was written, with the generation before it. */
    private static void requireLastRow(Checkpoint checkpoint, Path directory) throws IOException {
        long length = checkpoint.logs().getOrDefault(RunLayout.GENERATIONS, 0L);
        if (length == 0) {
            return;
        }
        byte[] table;
        try (InputStream in = Files.newInputStream(directory.resolve(RunLayout.GENERATIONS))) {
            table = in.readNBytes((int) Math.min(length, Integer.MAX_VALUE - 16));
        }
        String rows = new String(table, StandardCharsets.UTF_8).stripTrailing();
        String last = rows.substring(rows.lastIndexOf('\n') + 1);
        int before = checkpoint.evolution().generation() - 1;
        if (!last.startsWith(before + ",")) {
            throw new IllegalArgumentException("generation is " + (before + 1) + ", but the checkpoint's part of "
                    + RunLayout.GENERATIONS + " does not end with generation " + before);
        }
    }

    /**
     * Checks that the checkpoint contains all logs of the folder. A log unknown to the checkpoint would be overwritten.
     */
    private void requireAllLogs(Set<String> known, Path directory) throws IOException {
        Set<String> forgotten = new TreeSet<>();
        try (Stream<Path> files = Files.list(directory)) {
            files.map(file -> file.getFileName().toString())
                    .filter(name -> RunLayout.isLog(prefix, name) && !known.contains(name))
                    .forEach(forgotten::add);
        }
        if (!forgotten.isEmpty()) {
            throw new IllegalArgumentException("logs: no length of " + String.join(", ", forgotten));
        }
    }
}
