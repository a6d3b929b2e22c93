package mmneat.neat.io;

import java.io.IOException;
import org.jspecify.annotations.Nullable;

/** Thrown when a file has an invalid format. The message is one line: where in the file, and what is wrong. */
public final class GenotypeFormatException extends IOException {

    public GenotypeFormatException(String message) {
        super(message);
    }

    public GenotypeFormatException(@Nullable String message, Throwable cause) {
        super(message, cause);
    }
}
