package mmneat.neat.io;

import java.io.IOException;

/** A file is not what it should be. The message is one line: where in the file, what is wrong. */
public final class GenotypeFormatException extends IOException {

    public GenotypeFormatException(String message) {
        super(message);
    }

    public GenotypeFormatException(String message, Throwable cause) {
        super(message, cause);
    }
}
