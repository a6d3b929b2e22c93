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
 * The parts of a run's files that were written since the last sync. They survive a crash of the program, but a failure
 * of the machine may lose any of them. Checksums detect whether they are intact.
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
     * @param to index of the byte after its last one
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

    /** A stretch that grows. */
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

    /** Whether all stretches are in the folder as they were written. */
    static boolean areIntact(Path directory, Map<String, Stretch> stretches) throws IOException {
        for (Map.Entry<String, Stretch> stretch : stretches.entrySet()) {
            if (!stretch.getValue().isIntactIn(directory.resolve(stretch.getKey()))) {
                return false;
            }
        }
        return true;
    }

    /** Records that a file was replaced. */
    void replaced(String name, byte[] content) {
        Growing file = new Growing(0);
        file.add(content);
        files.put(name, file);
    }

    /** Records that a file of this length was appended to. */
    void appended(String name, long length, byte[] content) {
        files.computeIfAbsent(name, unused -> new Growing(length)).add(content);
    }

    /** Records that a folder was deleted with its files. */
    void deletedFolder(String name) {
        files.keySet().removeIf(file -> file.startsWith(name + "/"));
    }

    /** Number of files that are not synced. */
    public int count() {
        return files.size();
    }

    /** Returns the stretches that are not synced, by the name of the file. */
    public SortedMap<String, Stretch> stretches() {
        SortedMap<String, Stretch> stretches = new TreeMap<>();
        files.forEach((name, file) -> stretches.put(name, new Stretch(file.from, file.to, file.sum.getValue())));
        return stretches;
    }

    /** Syncs all files to the disk. */
    void sync() throws IOException {
        DurableFiles.sync(files.keySet().stream().map(directory::resolve).toList());
        files.clear();
    }
}
