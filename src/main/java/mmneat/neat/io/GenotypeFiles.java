package mmneat.neat.io;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import mmneat.neat.Genotype;

/** Reads genotypes from files of either form. */
public final class GenotypeFiles {

    /** Files beyond this many bytes are refused; a champion takes some 50,000. */
    static final long MAX_BYTES = 64L << 20;

    private GenotypeFiles() {}

    /**
     * Reads a genotype in our JSON or the original's XML; the first character tells which.
     *
     * @throws GenotypeFormatException if the file is damaged or something else; the message names file and field
     * @throws IOException if the file cannot be read
     */
    public static Genotype read(Path file) throws IOException {
        try {
            if (Files.size(file) > MAX_BYTES) {
                throw new GenotypeFormatException("is larger than " + (MAX_BYTES >> 20) + " MiB");
            }
            String text = Files.readString(file, StandardCharsets.UTF_8).strip();
            if (text.startsWith("{")) {
                return GenotypeJson.read(text);
            }
            if (text.startsWith("<")) {
                return GenotypeXml.read(text);
            }
            throw new GenotypeFormatException("is neither a genotype in JSON nor one of the original's XML files");
        } catch (GenotypeFormatException e) {
            throw new GenotypeFormatException(file + ": " + e.getMessage(), e);
        } catch (CharacterCodingException e) {
            throw new GenotypeFormatException(file + ": is not a text file", e);
        }
    }
}
