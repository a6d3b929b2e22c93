package mmneat.experiment;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;

/**
 * The newest checkpoint of a run and the one before it, {@code checkpoint.json.gz} and {@code checkpoint-previous.json.gz}.
 *
 * <p>The checksum is gzip's own (CRC-32 and length, at the end of the file): a checkpoint that was cut or changed is
 * recognised, and the previous one is used.
 */
final class CheckpointFile {

    private final Path newest;
    private final Path previous;

    CheckpointFile(Path directory) {
        newest = directory.resolve("checkpoint.json.gz");
        previous = directory.resolve("checkpoint-previous.json.gz");
    }

    /** Writes the next checkpoint; the newest until now becomes the previous one. */
    void save(byte[] json) throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream gzip = new GZIPOutputStream(packed)) {
            gzip.write(json);
        }
        DurableFiles.writeKeepingPrevious(newest, previous, packed.toByteArray());
    }

    /** Whether a run has begun here. */
    boolean exists() {
        return Files.exists(newest) || Files.exists(previous);
    }

    /**
     * The newest checkpoint that is whole.
     *
     * @return empty if there is none at all
     * @throws UserError if those that are there are damaged
     */
    Optional<byte[]> load() throws IOException {
        Optional<IOException> damage = Optional.empty();
        for (Path file : new Path[] {newest, previous}) {
            try (GZIPInputStream gzip = new GZIPInputStream(new ByteArrayInputStream(Files.readAllBytes(file)))) {
                return Optional.of(gzip.readAllBytes());
            } catch (NoSuchFileException e) {
                // Killed between two renames, or never written: the other file tells.
                continue;
            } catch (IOException e) {
                damage = Optional.of(e);
            }
        }
        if (damage.isPresent()) {
            throw new UserError(
                    newest + " and " + previous.getFileName() + ": no whole checkpoint ("
                            + damage.get().getMessage() + "); restore one of them, or delete " + newest.getParent()
                            + " to start the run again",
                    damage.get());
        }
        return Optional.empty();
    }
}
