package mmneat.experiment.store;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;

/** The checkpoints in the folder of a run, as tests read and change them. */
public final class SavedCheckpoint {

    private SavedCheckpoint() {}

    /** The newest one, unchecked. */
    public static Checkpoint newest(Path folder) throws IOException {
        return Checkpoint.fromJson(json(folder.resolve("checkpoint.json.gz")));
    }

    /** What a file of a checkpoint holds. */
    public static byte[] json(Path file) throws IOException {
        try (GZIPInputStream gzip = new GZIPInputStream(Files.newInputStream(file))) {
            return gzip.readAllBytes();
        }
    }

    /** Writes a file as that of a checkpoint. */
    public static void write(Path file, byte[] json) throws IOException {
        try (GZIPOutputStream gzip = new GZIPOutputStream(Files.newOutputStream(file))) {
            gzip.write(json);
        }
    }
}
