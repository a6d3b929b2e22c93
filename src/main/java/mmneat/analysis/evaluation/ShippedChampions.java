package mmneat.analysis.evaluation;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import mmneat.mspacman.TaskVersion;
import mmneat.neat.io.GenotypeFormatException;
import mmneat.neat.io.GenotypeJson;

/**
 * The champions that come with the program: one for each version of the task, named after it, and the best one of the
 * study. A name always means the same network, so that results that cite it can be repeated. This program evolved them;
 * docs/champions.md tells how, {@code scripts/evolve-champions} makes new ones.
 */
public final class ShippedChampions {

    /** Champions of the study in docs/study, as VERSION-RUN. */
    private static final List<String> OF_THE_STUDY = List.of("blended-2M2");

    private ShippedChampions() {}

    /** The names of the champions. */
    public static List<String> names() {
        return Stream.concat(TaskVersion.labels().stream(), OF_THE_STUDY.stream())
                .toList();
    }

    /**
     * Reads a champion.
     *
     * @param champion one of {@link #names()}
     * @throws IllegalArgumentException if there is no champion of this name
     */
    public static Champion read(String champion) {
        String name = "champion-" + champion + ".json";
        try (InputStream bytes = ShippedChampions.class.getResourceAsStream(name)) {
            if (bytes == null) {
                throw new IllegalArgumentException("no champion named " + champion + " comes with the program");
            }
            String json = new String(bytes.readAllBytes(), StandardCharsets.UTF_8);
            return new Champion(
                    GenotypeJson.read(json), Path.of(name), Optional.empty(), Map.of("task", champion.split("-")[0]));
        } catch (GenotypeFormatException e) {
            throw new IllegalStateException(name + ": " + e.getMessage(), e);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
