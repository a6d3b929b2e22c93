package mmneat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;

/**
 * The recorded outputs of the original, for conformance tests: one folder per part.
 *
 * <p>The full data are in the folder that the system property {@code golden.dir} names. Without that folder the tests
 * read the compact form in {@code src/test/resources/conformance}; its README says what differs.
 */
public final class GoldenData {

    private static final Path FULL = Path.of(System.getProperty("golden.dir", "../shared/golden"));

    private static final Map<String, Path> UNPACKED = new ConcurrentHashMap<>();

    private GoldenData() {}

    /** Whether the full data are there. */
    public static boolean isFull() {
        return Files.isDirectory(FULL);
    }

    /**
     * The folder of one part, such as {@code mazes} or {@code traces}.
     *
     * @throws AssertionError if the full data are missing although the environment says {@code CI=true}, or if neither
     *     form has the part
     */
    public static Path folder(String part) {
        if (isFull()) {
            return FULL.resolve(part);
        }
        if ("true".equals(System.getenv("CI"))) {
            throw new AssertionError(
                    "no golden data in " + FULL.toAbsolutePath().normalize());
        }
        return UNPACKED.computeIfAbsent(part, GoldenData::unpack);
    }

    private static Path unpack(String part) {
        try (InputStream zip = GoldenData.class.getResourceAsStream("/conformance/" + part + ".zip")) {
            if (zip == null) {
                throw new AssertionError("neither " + FULL + " nor src/test/resources/conformance has " + part);
            }
            Path folder = Files.createTempDirectory("mmneat-conformance-" + part);
            Runtime.getRuntime().addShutdownHook(new Thread(() -> delete(folder)));
            ZipInputStream entries = new ZipInputStream(zip);
            for (ZipEntry entry = entries.getNextEntry(); entry != null; entry = entries.getNextEntry()) {
                Path file = folder.resolve(entry.getName());
                Files.createDirectories(file.getParent());
                Files.copy(entries, file);
            }
            return folder;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void delete(Path folder) {
        try (var files = Files.walk(folder)) {
            files.sorted(java.util.Comparator.reverseOrder())
                    .forEach(file -> file.toFile().delete());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
