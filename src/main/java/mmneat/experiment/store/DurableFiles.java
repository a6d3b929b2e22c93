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
import java.util.Set;
import java.util.TreeSet;

/**
 * Writes files whole or not at all: to a temporary name, synced to disk, renamed. A crash or a full disk at any moment
 * leaves the old file or the new one. Symbolic links are replaced, never written through.
 */
public final class DurableFiles {

    /** What a file is called while it is being written; a leftover of a crash is overwritten by the next attempt. */
    static final String UNFINISHED = ".unfinished";

    private DurableFiles() {}

    /** Makes a folder if it does not exist, also on the disk. */
    public static void makeFolder(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) {
            Files.createDirectories(folder);
            sync(folder.toAbsolutePath().getParent());
        }
    }

    /** Writes a file, replacing it if it exists; its folder is made if it does not exist. */
    public static void write(Path file, byte[] content) throws IOException {
        makeFolder(file.toAbsolutePath().getParent());
        Path unfinished = writeUnfinished(file, content, true);
        rename(unfinished, file);
    }

    /**
     * Writes a file that a user named: the file behind a symbolic link is replaced and the link stays; a device or a pipe, such
     * as {@code /dev/stdout}, is written to.
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
     * Replaces a file at once, but leaves it to the operating system when it reaches the disk: the program may die at any
     * moment, but after a failure of the power the file may be empty unless {@link #sync} was called.
     */
    static void replace(Path file, byte[] content) throws IOException {
        makeFolder(file.toAbsolutePath().getParent());
        Path unfinished = writeUnfinished(file, content, false);
        Files.move(unfinished, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }

    /** Waits until the files are on the disk, under their names. */
    public static void sync(Collection<Path> files) throws IOException {
        Set<Path> folders = new TreeSet<>();
        for (Path file : files) {
            try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS)) {
                channel.force(true);
            }
            folders.add(file.toAbsolutePath().getParent());
        }
        for (Path folder : folders) {
            sync(folder);
        }
    }

    /** Gives a file another name, also on the disk. */
    static void rename(Path from, Path to) throws IOException {
        Files.move(from, to, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        sync(to.toAbsolutePath().getParent());
    }

    /** Cuts a file at the length and adds to it; {@link #sync} puts it on the disk. */
    static void appendAt(Path file, long length, byte[] content) throws IOException {
        makeFolder(file.toAbsolutePath().getParent());
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
            // On a full disk the part that was written takes space and is of no use.
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

    /** A rename is on disk when the folder is. Windows does not open folders and writes renames by itself. */
    private static void sync(Path folder) throws IOException {
        if (File.separatorChar == '/') {
            try (FileChannel channel = FileChannel.open(folder, StandardOpenOption.READ)) {
                channel.force(true);
            }
        }
    }
}
