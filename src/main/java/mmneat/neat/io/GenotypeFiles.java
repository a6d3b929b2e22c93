package mmneat.neat.io;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import mmneat.neat.Genotype;

/** Reads genotypes from JSON and XML files. */
public final class GenotypeFiles {

    /** Maximum size of a file in bytes; a champion takes about 50,000. */
    static final long MAX_BYTES = 64L << 20;

    private static final String BYTE_ORDER_MARK = "\uFEFF";

    private GenotypeFiles() {}

    /**
     * Reads a genotype in our JSON or the original's XML form, which it recognises by the first character.
     *
     * @throws GenotypeFormatException if the file is damaged or does not contain a genotype; the message names file and
     *     field
     * @throws IOException if the file cannot be read
     */
    public static Genotype read(Path file) throws IOException {
        try {
            String text = textOf(file);
            if (text.startsWith("{")) {
                return GenotypeJson.read(text);
            }
            if (text.startsWith("<")) {
                return GenotypeXml.read(text);
            }
            if (text.isEmpty()) {
                throw new GenotypeFormatException("is empty; restore it or give another file with a network");
            }
            throw new GenotypeFormatException("is neither a genotype in JSON nor an XML file of the original; "
                    + "give a file with a network, such as champion.json in the folder of a run");
        } catch (GenotypeFormatException e) {
            throw new GenotypeFormatException(file + ": " + e.getMessage(), e);
        } catch (CharacterCodingException e) {
            throw new GenotypeFormatException(file + ": is not a text file", e);
        }
    }

    /** Returns the text of a file without surrounding white space and without a byte order mark. */
    private static String textOf(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            // The size is checked while reading, because pipes and devices report none.
            byte[] bytes = in.readNBytes((int) MAX_BYTES + 1);
            if (bytes.length > MAX_BYTES) {
                throw new GenotypeFormatException("is larger than " + (MAX_BYTES >> 20) + " MiB");
            }
            String text = StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(bytes))
                    .toString();
            return (text.startsWith(BYTE_ORDER_MARK) ? text.substring(1) : text).strip();
        }
    }
}
