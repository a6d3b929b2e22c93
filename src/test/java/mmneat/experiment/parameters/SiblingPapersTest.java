package mmneat.experiment.parameters;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import mmneat.GoldenData;
import mmneat.experiment.run.ExperimentPlan;
import mmneat.mspacman.TaskVersion;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The configurations of experiments of other papers equal the original's command lines. */
@Tag("conformance")
class SiblingPapersTest {

    /** Parameters that differ between runs, and sizes that were reduced for the recorded runs. */
    private static final Set<String> OF_THE_RUN = Set.of(
            "config", "runNumber", "randomSeed", "base", "saveTo", "log", "mu", "maxGens", "trials", "io", "netio");

    private final ParameterReader reader = new ParameterReader(ParameterCatalogue.load());

    private static List<Path> files() throws IOException {
        List<Path> files = new ArrayList<>();
        for (String paper : List.of("tciaig-2016", "dissertation-2014")) {
            try (Stream<Path> found = Files.walk(Path.of("configs", paper))) {
                found.filter(Files::isRegularFile).forEach(files::add);
            }
        }
        return files;
    }

    /** {@code # The published experiment MsPacMan-OneLifeSplit-MMD: ...} */
    private static String experiment(Path file) throws IOException {
        String line = Files.readAllLines(file).get(0);
        return line.replaceFirst("^# The published experiment MsPacMan-([\\w-]+):.*", "$1");
    }

    private Map<String, String> values(Stream<String> words) {
        Map<String, String> values =
                new TreeMap<>(reader.read(words.toList()).parameters().values());
        values.keySet().removeAll(OF_THE_RUN);
        return values;
    }

    @Test
    void eachFile_meansTheCommandLineOfItsExperiment() throws IOException {
        for (Path file : files()) {
            Path recorded = GoldenData.folder("runs-options").resolve(experiment(file));
            String words = Files.readString(recorded.resolve("command.txt")).strip();
            assertThat(values(Stream.of("config=" + file)))
                    .as(file.toString())
                    .isEqualTo(values(Arrays.stream(words.split(" "))));
        }
    }

    @Test
    void allEighteenExperiments_haveAFile() throws IOException {
        Set<String> experiments = new TreeSet<>();
        for (Path file : files()) {
            experiments.add(experiment(file));
        }
        try (Stream<Path> recorded = Files.list(GoldenData.folder("runs-options"))) {
            assertThat(experiments)
                    .hasSize(18)
                    .containsExactlyInAnyOrderElementsOf(
                            recorded.map(folder -> folder.getFileName().toString())
                                    .filter(name -> name.contains("Split-") || name.contains("-TUG"))
                                    .toList());
        }
    }

    @Test
    void noConfiguration_isTakenForAMethodOfThePaper() throws IOException {
        for (Path file : files()) {
            Parameters parameters = reader.read(List.of("config=" + file)).parameters();
            TaskVersion version = PublishedTask.version(parameters).orElseThrow();
            String method = PublishedTask.method(parameters.values()).orElseThrow();
            if (PublishedConfigurations.methodsOf(version).contains(method)) {
                Map<String, String> differences = PublishedTask.differences(version, method, parameters.values());
                assertThat(PublishedTask.changesTheMethod(differences.keySet()))
                        .as(file.toString())
                        .isTrue();
            }
        }
    }

    @Test
    void fileIsFound_byItsName_fromAnywhere_andNamesTheRuns() throws IOException {
        for (Path file : files()) {
            String name = file.toString().replaceFirst("^configs/", "").replaceFirst("\\.properties$", "");
            ExperimentPlan plan = ExperimentPlan.of(
                    reader.read(List.of("config=" + name, "runs=2")).parameters());
            assertThat(plan.base())
                    .isEqualTo(Path.of("results").resolve(Path.of(name).getParent()));
            String method = String.valueOf(Path.of(name).getFileName());
            assertThat(plan.runs().get(1).directory().getFileName()).hasToString(method + "1");
            assertThat(PublishedTask.method(plan.parameters().values()).orElseThrow())
                    .isEqualTo(method);
        }
    }

    @Test
    void sizeOfTheRunAndSelection_areDifferences() {
        assertThat(PublishedTask.differences(
                        TaskVersion.BLENDED,
                        "2M",
                        Map.of("mu", "50", "maxGens", "200", "trials", "3", "crowding", "front", "base", "elsewhere")))
                .containsOnly(Map.entry("mu", "100"), Map.entry("trials", "10"), Map.entry("crowding", "population"));
    }
}
