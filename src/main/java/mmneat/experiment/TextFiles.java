package mmneat.experiment;

import java.io.IOException;
import java.io.InputStream;
import java.io.Reader;
import java.io.StringReader;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Reader of whole files. The size is limited while reading, because a file of another person may be larger than the
 * memory, and a device has no end.
 */
public final class TextFiles {

    /** Maximum size of files of settings and states, in MiB; those of the program have some kilobytes. */
    public static final int SETTINGS_MIB = 1;

    /** Maximum size of tables, logs and recordings, in MiB; those of the paper's runs have less than one. */
    public static final int TABLE_MIB = 256;

    private TextFiles() {}

    /**
     * Returns the bytes of a file.
     *
     * @param maximumMib the maximum size in MiB
     * @throws FileSystemException if it is larger or a folder
     * @throws IOException if it cannot be read
     */
    public static byte[] bytes(Path file, int maximumMib) throws IOException {
        if (Files.isDirectory(file)) {
            throw new FileSystemException(file.toString(), null, "it is a folder; name a file in it");
        }
        try (InputStream in = Files.newInputStream(file)) {
            byte[] bytes = in.readNBytes((maximumMib << 20) + 1);
            if (bytes.length > maximumMib << 20) {
                throw new FileSystemException(file.toString(), null, "it is larger than " + maximumMib + " MiB");
            }
            return bytes;
        }
    }

    /**
     * Returns the text of a file in UTF-8.
     *
     * @param maximumMib the maximum size in MiB
     * @throws IOException if it is larger, not in UTF-8, or cannot be read
     */
    public static String text(Path file, int maximumMib) throws IOException {
        return StandardCharsets.UTF_8
                .newDecoder()
                .decode(ByteBuffer.wrap(bytes(file, maximumMib)))
                .toString();
    }

    /**
     * Returns a reader of a table or recording in UTF-8, which is read at once.
     *
     * @throws IOException if it is larger than {@value #TABLE_MIB} MiB, not in UTF-8, or cannot be read
     */
    public static Reader reader(Path file) throws IOException {
        return new StringReader(text(file, TABLE_MIB));
    }

    /**
     * Returns the lines of a table or log in UTF-8.
     *
     * @throws UserError if it cannot be read
     */
    public static List<String> lines(Path file) {
        try {
            return text(file, TABLE_MIB).lines().toList();
        } catch (IOException e) {
            throw FileErrors.unreadable(file, e);
        }
    }
}
