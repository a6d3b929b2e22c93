package mmneat.experiment.store;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import mmneat.experiment.UserError;

/**
 * The newest checkpoint of a run, {@code checkpoint.json.gz}, and the one to fall back on,
 * {@code checkpoint-previous.json.gz}.
 *
 * <p>The checksum is gzip's own (CRC-32 and length, at the end of the file): a checkpoint that was cut or changed is
 * recognised, and the previous one is used. It is used, too, if the newest one tells of files that are not what they were.
 *
 * <p>A checkpoint that was forced to the disk, together with the files that it tells of, outlives a failure of the machine. At
 * any moment at least one of the two is such a one, from the first that is saved on.
 */
public final class CheckpointFile {

    private final Path directory;
    private final Path newest;
    private final Path previous;
    private boolean newestOutlivesTheMachine;

    public CheckpointFile(Path directory) {
        this.directory = directory;
        newest = directory.resolve(RunLayout.CHECKPOINT);
        previous = directory.resolve(RunLayout.PREVIOUS_CHECKPOINT);
    }

    /** Writes the next checkpoint, and forces it to the disk if the files that it tells of were. */
    public void save(Checkpoint checkpoint) throws IOException {
        byte[] packed = pack(checkpoint.toJson());
        if (newestOutlivesTheMachine) {
            newestOutlivesTheMachine = false;
            DurableFiles.rename(newest, previous);
        }
        if (checkpoint.wasForced()) {
            DurableFiles.write(newest, packed);
            newestOutlivesTheMachine = true;
        } else {
            DurableFiles.replace(newest, packed);
        }
    }

    private static byte[] pack(byte[] json) throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream gzip = new GZIPOutputStream(packed)) {
            gzip.write(json);
        }
        return packed.toByteArray();
    }

    /** Whether a run has begun here. */
    boolean exists() {
        return Files.exists(newest) || Files.exists(previous);
    }

    /**
     * The newest checkpoint that is whole and whose files are.
     *
     * @return empty if there is none at all
     * @throws UserError if those that are there are damaged
     */
    public Optional<Checkpoint> load() throws IOException {
        newestOutlivesTheMachine = false;
        String damage = "";
        for (Path file : new Path[] {newest, previous}) {
            try (GZIPInputStream gzip = new GZIPInputStream(new ByteArrayInputStream(Files.readAllBytes(file)))) {
                Checkpoint checkpoint = Checkpoint.fromJson(gzip.readAllBytes(), directory);
                if (UnsyncedFiles.areIntact(directory, checkpoint.unforced())) {
                    newestOutlivesTheMachine = file.equals(newest) && checkpoint.wasForced();
                    return Optional.of(checkpoint);
                }
                damage = "files of generation " + (checkpoint.evolution().generation() - 1) + " are damaged";
            } catch (NoSuchFileException e) {
                // Killed between two renames, or never written: the other file tells.
                continue;
            } catch (IOException e) {
                damage = String.valueOf(e.getMessage());
            }
        }
        if (!damage.isEmpty()) {
            throw new UserError(newest + " and " + previous.getFileName() + ": no whole checkpoint (" + damage
                    + "); restore one of them, or delete " + directory + " to start the run again");
        }
        return Optional.empty();
    }
}
