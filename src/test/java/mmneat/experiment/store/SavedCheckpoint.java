package mmneat.experiment.store;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;

/** Reads and writes the checkpoints of a run for tests. */
public final class SavedCheckpoint {

    private SavedCheckpoint() {}

    /** Returns the newest checkpoint, unchecked. */
    public static Checkpoint newest(Path folder) throws IOException {
        return Checkpoint.fromJson(json(folder.resolve("checkpoint.json.gz")));
    }

    /** Returns the JSON content of a checkpoint file. */
    public static byte[] json(Path file) throws IOException {
        try (GZIPInputStream gzip = new GZIPInputStream(Files.newInputStream(file))) {
            return gzip.readAllBytes();
        }
    }

    /** Writes JSON content as a checkpoint file. */
    public static void write(Path file, byte[] json) throws IOException {
        try (GZIPOutputStream gzip = new GZIPOutputStream(Files.newOutputStream(file))) {
            gzip.write(json);
        }
    }
}
