package mmneat.experiment.store;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import mmneat.experiment.UserError;

/**
 * Saves and loads the checkpoints of a run: the newest, {@code checkpoint.json.gz}, and the previous one, {@code
 * checkpoint-previous.json.gz}.
 *
 * <p>The checksum is gzip's own (CRC-32 and length, at the end of the file): a truncated or changed checkpoint is
 * detected, and the previous one is used. The previous one is also used if files recorded in the newest one have
 * changed.
 *
 * <p>A checkpoint that was synced to the disk together with the files recorded in it survives a failure of the machine.
 * The first checkpoint of a run is synced. An unsynced checkpoint is overwritten by the next one; only a synced one is
 * kept as the previous checkpoint. So at least one of the two files is always synced, and "previous" means the last
 * synced checkpoint before the newest one.
 */
public final class CheckpointFile {

    private static final int BUFFER_BYTES = 1 << 16;

    /** Compression level of {@link java.util.zip.Deflater}, which by default takes 6. */
    private static final int FAST_LEVEL = 3;

    private final Path directory;
    private final Path newest;
    private final Path previous;
    private boolean newestOutlivesTheMachine;
    private String damage = "";

    public CheckpointFile(Path directory) {
        this.directory = directory;
        newest = directory.resolve(RunLayout.CHECKPOINT);
        previous = directory.resolve(RunLayout.PREVIOUS_CHECKPOINT);
    }

    /**
     * Writes the next checkpoint, and syncs it to the disk if the files recorded in it were synced. If the newest
     * checkpoint so far was synced, it becomes the previous one; otherwise it is overwritten.
     *
     * @param checkpoint must be synced if the folder has no checkpoint yet
     */
    public void save(Checkpoint checkpoint) throws IOException {
        byte[] packed = pack(checkpoint.toJson());
        if (newestOutlivesTheMachine) {
            newestOutlivesTheMachine = false;
            DurableFiles.rename(newest, previous);
        }
        if (checkpoint.wasSynced()) {
            DurableFiles.write(newest, packed);
            newestOutlivesTheMachine = true;
        } else {
            DurableFiles.replace(newest, packed);
        }
    }

    private static byte[] pack(byte[] json) throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream gzip = new FastGzip(packed)) {
            gzip.write(json);
        }
        return packed.toByteArray();
    }

    /** A gzip stream that prefers speed to size: less than half of the usual time, for a file that is half larger. */
    private static final class FastGzip extends GZIPOutputStream {
        FastGzip(OutputStream target) throws IOException {
            super(target, BUFFER_BYTES);
            def.setLevel(FAST_LEVEL);
        }
    }

    /** Whether a run was started in this folder. */
    boolean exists() {
        return Files.exists(newest) || Files.exists(previous);
    }

    /**
     * Checks that the folder has no run that cannot be continued. Allowed are a folder with a checkpoint, from which
     * the run continues, and a folder without files of a run. Call it before a run starts or continues: in any other
     * folder it would overwrite the results of the original, or of a run whose checkpoints were deleted.
     *
     * @throws UserError if the folder has files of a run but no checkpoint
     */
    public void requireNoOrphanedRun() throws IOException {
        if (exists() || !Files.isDirectory(directory)) {
            return;
        }
        try (Stream<Path> entries = Files.list(directory)) {
            List<String> found = entries.map(entry -> entry.getFileName().toString())
                    .filter(RunLayout::isNamedAsOfARun)
                    .sorted()
                    .toList();
            if (!found.isEmpty()) {
                throw new UserError(directory + ": holds files of a run (" + found.get(0)
                        + (found.size() > 1 ? " and " + (found.size() - 1) + " more" : "")
                        + ") but no checkpoint to continue it from, and no file in it is replaced: give another folder with"
                        + " base=FOLDER or saveTo=NAME, or move these files away");
            }
        }
    }

    /**
     * Returns the newest checkpoint that is undamaged, passes the check, and whose files are unchanged.
     *
     * @return empty if there is no checkpoint
     * @throws UserError if all existing checkpoints are damaged, or one names files that are not of its run
     */
    public Optional<Checkpoint> load(CheckpointCheck check) throws IOException {
        newestOutlivesTheMachine = false;
        damage = "";
        for (Path file : new Path[] {newest, previous}) {
            OrdinaryFiles.require(file);
            try {
                Checkpoint checkpoint = Checkpoint.fromJson(unpack(file, check.maximumBytes()));
                check.require(checkpoint, directory);
                if (UnsyncedFiles.areIntact(directory, checkpoint.unsynced())) {
                    newestOutlivesTheMachine = file.equals(newest) && checkpoint.wasSynced();
                    return Optional.of(checkpoint);
                }
                noteDamage(
                        file, "files of generation " + (checkpoint.evolution().generation() - 1) + " are damaged");
            } catch (NoSuchFileException e) {
                // The program was killed between two renames, or the file was never written: try the other file.
                continue;
            } catch (EOFException e) {
                noteDamage(file, "it is cut off");
            } catch (IOException | IllegalArgumentException e) {
                noteDamage(file, String.valueOf(e.getMessage()));
            }
        }
        if (!damage.isEmpty()) {
            throw new UserError(directory + ": has no undamaged checkpoint: " + damage
                    + "; restore one, continue with the version of the program that began the run, or delete "
                    + directory
                    + " to start the run again");
        }
        return Optional.empty();
    }

    private static byte[] unpack(Path file, long maximumBytes) throws IOException {
        try (GZIPInputStream gzip =
                new GZIPInputStream(Files.newInputStream(file, LinkOption.NOFOLLOW_LINKS), BUFFER_BYTES)) {
            byte[] json = gzip.readNBytes((int) maximumBytes + 1);
            if (json.length > maximumBytes) {
                throw new IOException("it is larger than " + (maximumBytes >> 20) + " MiB when unpacked");
            }
            return json;
        }
    }

    private void noteDamage(Path file, String reason) {
        damage += (damage.isEmpty() ? "" : "; ") + file.getFileName() + ": " + reason;
    }

    /**
     * Returns what was wrong with the checkpoints that {@link #load} rejected, in one line; empty if it rejected none.
     */
    public String damage() {
        return damage;
    }
}
