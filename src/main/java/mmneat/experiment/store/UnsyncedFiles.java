package mmneat.experiment.store;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.zip.CRC32C;

/**
 * What was written into a run's folder since it was last synced to the disk: if the machine fails, as against the program,
 * the operating system may have lost any of it. Checksums tell whether it is still there.
 */
public final class UnsyncedFiles {

    private static final int BLOCK_BYTES = 1 << 16;

    private final Path directory;

    /** By the name of the file, relative to the folder. */
    private final SortedMap<String, Growing> files = new TreeMap<>();

    UnsyncedFiles(Path directory) {
        this.directory = directory;
    }

    /**
     * A stretch of a file.
     *
     * @param from index of its first byte
     * @param to index of the first byte behind it
     * @param checksum its CRC-32C
     */
    public record Stretch(long from, long to, long checksum) {

        boolean isIntactIn(Path file) throws IOException {
            try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ, LinkOption.NOFOLLOW_LINKS)) {
                CRC32C sum = new CRC32C();
                ByteBuffer bytes = ByteBuffer.allocate(BLOCK_BYTES);
                long position = from;
                while (position < to) {
                    bytes.clear().limit((int) Math.min(BLOCK_BYTES, to - position));
                    int count = channel.read(bytes, position);
                    if (count < 0) {
                        return false;
                    }
                    sum.update(bytes.flip());
                    position += count;
                }
                return sum.getValue() == checksum;
            } catch (NoSuchFileException e) {
                return false;
            }
        }
    }

    /** A stretch that is added to. */
    private static final class Growing {
        private final CRC32C sum = new CRC32C();
        private final long from;
        private long to;

        Growing(long from) {
            this.from = from;
            to = from;
        }

        void add(byte[] content) {
            sum.update(content);
            to += content.length;
        }
    }

    /** Whether all stretches are on the disk as they were written. */
    static boolean areIntact(Path directory, Map<String, Stretch> stretches) throws IOException {
        for (Map.Entry<String, Stretch> stretch : stretches.entrySet()) {
            if (!stretch.getValue().isIntactIn(directory.resolve(stretch.getKey()))) {
                return false;
            }
        }
        return true;
    }

    /** Notes that a file was written anew. */
    void replaced(String name, byte[] content) {
        Growing file = new Growing(0);
        file.add(content);
        files.put(name, file);
    }

    /** Notes that a file, which was so long, got longer. */
    void appended(String name, long length, byte[] content) {
        files.computeIfAbsent(name, unused -> new Growing(length)).add(content);
    }

    /** Notes that a folder was deleted with what was in it. */
    void deletedFolder(String name) {
        files.keySet().removeIf(file -> file.startsWith(name + "/"));
    }

    /** How many files wait to be synced. */
    public int count() {
        return files.size();
    }

    /** What waits to be synced, by the name of the file. */
    public SortedMap<String, Stretch> stretches() {
        SortedMap<String, Stretch> stretches = new TreeMap<>();
        files.forEach((name, file) -> stretches.put(name, new Stretch(file.from, file.to, file.sum.getValue())));
        return stretches;
    }

    /** Waits until everything is on the disk. */
    void sync() throws IOException {
        DurableFiles.sync(files.keySet().stream().map(directory::resolve).toList());
        files.clear();
    }
}
