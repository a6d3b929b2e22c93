package mmneat.experiment.store;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Stream;
import mmneat.evolution.EvolutionSettings;
import mmneat.experiment.UserError;

/**
 * What a checkpoint has to fulfil for a run to continue from it: it names files of this run alone, and its state is one that an
 * evolution with these settings can be in.
 */
public final class CheckpointCheck {

    /** Room for all but the genotypes, in bytes of JSON. */
    private static final long ROOM_FOR_THE_REST = 16L << 20;

    /** Room for a genotype: some ten thousand genes. */
    private static final long ROOM_FOR_A_GENOTYPE = 1L << 20;

    private final EvolutionSettings settings;
    private final String prefix;

    /**
     * A check for one run.
     *
     * @param prefix what the names of its score files and logs start with
     */
    public CheckpointCheck(EvolutionSettings settings, String prefix) {
        this.settings = settings;
        this.prefix = prefix;
    }

    /** The size from which on an unpacked checkpoint is refused, in bytes: it may be made to fill the memory. */
    long maximumBytes() {
        return Math.min(Integer.MAX_VALUE - 16L, ROOM_FOR_THE_REST + ROOM_FOR_A_GENOTYPE * settings.populationSize());
    }

    /**
     * Makes sure that the run of a folder can continue from a checkpoint.
     *
     * @throws UserError if the checkpoint names a file that is not of this run
     * @throws IllegalArgumentException if it is damaged; the message says what is wrong
     * @throws IOException if a log cannot be looked at
     */
    void require(Checkpoint checkpoint, Path directory) throws IOException {
        requireNames(checkpoint.logs().keySet(), name -> RunLayout.isLog(prefix, name), directory);
        requireNames(checkpoint.unsynced().keySet(), name -> RunLayout.isWrittenByRun(prefix, name), directory);
        for (Map.Entry<String, Long> log : checkpoint.logs().entrySet()) {
            requireLength(log.getKey(), log.getValue(), directory);
        }
        if (checkpoint.evolution().generation() > 0) {
            requireAllLogs(checkpoint.logs().keySet(), directory);
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
                    directory + ": its checkpoint names '" + name + "', which is no file of this run; the folder"
                            + " was changed by hand, and nothing in it is touched: restore the checkpoint or give another folder with"
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

    /** A log that the checkpoint does not know would be begun anew. */
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
