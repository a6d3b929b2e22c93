package mmneat.experiment.store;

import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Collection;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;

/**
 * Writes files atomically: under a temporary name, synced to disk, then renamed. A crash or a full disk leaves either
 * the old file or the new one. Symbolic links are replaced, never written through.
 */
public final class DurableFiles {

    /** Suffix of a file while it is being written. The next attempt overwrites what a crash left behind. */
    static final String UNFINISHED = ".unfinished";

    private DurableFiles() {}

    /** Makes a folder if it does not exist, and syncs it. */
    public static void makeFolder(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) {
            Files.createDirectories(folder);
            sync(folderOf(folder));
        }
    }

    /** Writes a file, replacing it if it exists; its folder is made if it does not exist. */
    public static void write(Path file, byte[] content) throws IOException {
        makeFolder(folderOf(file));
        Path unfinished = writeUnfinished(file, content, true);
        rename(unfinished, file);
    }

    /**
     * Writes a file that a user named: the file behind a symbolic link is replaced and the link stays; a device or a
     * pipe, such as {@code /dev/stdout}, is written to.
     */
    public static void writeNamed(Path file, byte[] content) throws IOException {
        if (!Files.exists(file)) {
            write(file, content);
        } else if (Files.isRegularFile(file)) {
            write(file.toRealPath(), content);
        } else {
            Files.write(file, content);
        }
    }

    /**
     * Replaces a file without syncing it. The file survives if the program is killed. After a power failure it may be
     * empty, unless {@link #sync} was called.
     */
    static void replace(Path file, byte[] content) throws IOException {
        makeFolder(folderOf(file));
        Path unfinished = writeUnfinished(file, content, false);
        Files.move(unfinished, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }

    /** Syncs the files and their names to the disk. */
    public static void sync(Collection<Path> files) throws IOException {
        Set<Path> folders = new TreeSet<>();
        for (Path file : files) {
            try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS)) {
                channel.force(true);
            }
            folders.add(folderOf(file));
        }
        for (Path folder : folders) {
            sync(folder);
        }
    }

    /** Renames a file and syncs its folder. */
    static void rename(Path from, Path to) throws IOException {
        Files.move(from, to, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        sync(folderOf(to));
    }

    /** Truncates a file to the length and appends to it, without syncing. */
    static void appendAt(Path file, long length, byte[] content) throws IOException {
        makeFolder(folderOf(file));
        try (FileChannel channel = FileChannel.open(
                file, StandardOpenOption.WRITE, StandardOpenOption.CREATE, LinkOption.NOFOLLOW_LINKS)) {
            channel.truncate(length);
            channel.position(length);
            writeFully(channel, content);
        }
    }

    private static Path writeUnfinished(Path file, byte[] content, boolean syncs) throws IOException {
        Path unfinished = file.resolveSibling(file.getFileName() + UNFINISHED);
        try (FileChannel channel = FileChannel.open(
                unfinished,
                StandardOpenOption.WRITE,
                StandardOpenOption.CREATE,
                StandardOpenOption.TRUNCATE_EXISTING,
                LinkOption.NOFOLLOW_LINKS)) {
            writeFully(channel, content);
            if (syncs) {
                channel.force(true);
            }
        } catch (IOException e) {
            // After a full disk the partial content is useless and takes space.
            Files.deleteIfExists(unfinished);
            throw e;
        }
        return unfinished;
    }

    private static void writeFully(FileChannel channel, byte[] content) throws IOException {
        ByteBuffer buffer = ByteBuffer.wrap(content);
        while (buffer.hasRemaining()) {
            channel.write(buffer);
        }
    }

    /** Syncs a folder, and with it the renames in it. Windows cannot open folders and syncs renames by itself. */
    private static Path folderOf(Path file) {
        return Objects.requireNonNull(file.toAbsolutePath().getParent(), "the root of a file system");
    }

    private static void sync(Path folder) throws IOException {
        if (File.separatorChar == '/') {
            try (FileChannel channel = FileChannel.open(folder, StandardOpenOption.READ)) {
                channel.force(true);
            }
        }
    }
}
