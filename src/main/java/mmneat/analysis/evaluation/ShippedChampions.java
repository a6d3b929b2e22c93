package mmneat.analysis.evaluation;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import mmneat.mspacman.TaskVersion;
import mmneat.neat.io.GenotypeFormatException;
import mmneat.neat.io.GenotypeJson;

/**
 * The champions that come with the program, one for each version of the task. This program evolved them;
 * docs/champions.md tells how, {@code scripts/evolve-champions} makes new ones.
 */
public final class ShippedChampions {

    private ShippedChampions() {}

    /** The versions that have a champion. */
    public static List<String> versions() {
        return TaskVersion.labels();
    }

    /**
     * The champion of a version.
     *
     * @throws IllegalArgumentException if it is none of {@link #versions()}
     */
    public static Champion read(String version) {
        String name = "champion-" + version + ".json";
        try (InputStream bytes = ShippedChampions.class.getResourceAsStream(name)) {
            if (bytes == null) {
                throw new IllegalArgumentException("no champion of the version " + version + " comes with the program");
            }
            String json = new String(bytes.readAllBytes(), StandardCharsets.UTF_8);
            return new Champion(GenotypeJson.read(json), Path.of(name), Optional.empty(), Map.of("task", version));
        } catch (GenotypeFormatException e) {
            throw new IllegalStateException(name + ": " + e.getMessage(), e);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
