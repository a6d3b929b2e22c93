package mmneat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Assumptions;

/**
 * Where the conformance tests find what the original produced: one folder per part, below the folder that the system
 * property {@code golden.dir} names.
 */
public final class GoldenData {

    private GoldenData() {}

    /**
     * The folder of one part, such as {@code mazes} or {@code traces}. When it is missing the calling test is skipped, or
     * fails if the environment says {@code CI=true}.
     */
    public static Path folder(String part) {
        Path folder = Path.of(System.getProperty("golden.dir", "../shared/golden"), part);
        if (!Files.isDirectory(folder)) {
            String message = "no golden data in " + folder.toAbsolutePath().normalize();
            if ("true".equals(System.getenv("CI"))) {
                throw new AssertionError(message);
            }
            Assumptions.abort(message);
        }
        return folder;
    }
}
