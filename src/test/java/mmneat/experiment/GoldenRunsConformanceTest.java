package mmneat.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import mmneat.GoldenData;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The sixteen published command lines write the original's files, byte for byte: golden/runs. So do the runs of golden/logs,
 * other options and another seed.
 */
@Tag("conformance")
class GoldenRunsConformanceTest {

    @TempDir
    Path base;

    @ParameterizedTest
    @ValueSource(
            strings = {
                "OneLifeConflict-OneModule",
                "OneLifeConflict-TwoModules",
                "OneLifeConflict-ThreeModules",
                "OneLifeConflict-MMD",
                "OneLifeConflict-TwoModuleMultitask",
                "OneLifeConflict-ThreeModuleMultitask",
                "ImprisonConflict-OneModule",
                "ImprisonConflict-TwoModules",
                "ImprisonConflict-ThreeModules",
                "ImprisonConflict-MMD",
                "ImprisonConflict-Multitask",
                "IsolatedConflict-OneModule",
                "IsolatedConflict-TwoModules",
                "IsolatedConflict-ThreeModules",
                "IsolatedConflict-MMD",
                "IsolatedConflict-Multitask"
            })
    void publishedCommandLine_writesTheOriginalsFiles(String configuration) throws Exception {
        Path golden = GoldenData.folder("runs").resolve(configuration);
        run(commandLine(golden));
        requireSameFiles(golden);
    }

    @Test
    void runSideBySideWithOthers_writesTheOriginalsFiles() throws Exception {
        Path golden = GoldenData.folder("runs").resolve("OneLifeConflict-MMD");
        Stream<String> allRuns =
                commandLine(golden).filter(word -> !word.startsWith("runNumber:") && !word.startsWith("randomSeed:"));
        run(Stream.concat(allRuns, Stream.of("runs=3", "threads=3")));
        requireSameFiles(golden);
        assertThat(base.resolve("MMD2/OneLifeConflict-MMD2_parents_log.txt")).isNotEmptyFile();
    }

    @Test
    void runOfTheLogs_writesTheOriginalsFiles() throws Exception {
        Path golden = GoldenData.folder("logs");
        Stream<String> published = commandLine(GoldenData.folder("runs").resolve("OneLifeConflict-MMD"));
        List<String> others = List.of("randomSeed:3", "maxGens:3", "mu:6", "trials:2", "log:P-MMD");
        List<String> replaced =
                others.stream().map(word -> word.split(":")[0] + ":").toList();
        run(Stream.concat(published.filter(word -> replaced.stream().noneMatch(word::startsWith)), others.stream()));
        Path folder = base.resolve("MMD0");
        try (Stream<Path> files = Files.list(golden)) {
            files.filter(file -> file.getFileName()
                            .toString()
                            .matches("P-MMD0_(parents|child|TWEANNData|ModeUsage|Mutations|Lineage).*"))
                    .filter(file -> !file.toString().contains("genHV"))
                    .forEach(file -> requireSame(folder.resolve(file.getFileName()), file));
        }
        requireSame(folder.resolve("P-MMD0_Performance_log.plot"), golden.resolve("P-MMD0_Performance_log.plot"));
        requireSame(folder.resolve("bestPacMan/score.txt"), golden.resolve("bestPacMan_score.txt"));
        requireSame(folder.resolve("bestObjectives/score0.txt"), golden.resolve("bestObjectives_score0.txt"));
        requireSame(folder.resolve("bestObjectives/score1.txt"), golden.resolve("bestObjectives_score1.txt"));
        requireSame(folder.resolve("combiningCrossoverMapping.txt"), golden.resolve("combiningCrossoverMapping.txt"));
    }

    /** The words of the published command, its files found where the golden data are and its results put away here. */
    private Stream<String> commandLine(Path golden) throws IOException {
        Path locations = GoldenData.folder("ghost-locations").resolve("PowerPillToGhostLocationMapping.txt");
        return Arrays.stream(
                        Files.readString(golden.resolve("command.txt")).strip().split(" "))
                .map(word -> word.startsWith("base:") ? "base:" + base : word)
                .map(word -> word.startsWith("mazePowerPillGhostMapping:")
                        ? "mazePowerPillGhostMapping:" + locations
                        : word);
    }

    private static void run(Stream<String> words) throws InterruptedException {
        ParameterReader reader = new ParameterReader(ParameterCatalogue.load());
        ExperimentPlan plan = ExperimentPlan.of(reader.read(words.toList()).parameters());
        assertThat(new Experiment(plan).run())
                .allSatisfy(outcome ->
                        assertThat(outcome.isComplete()).as(outcome.message()).isTrue());
    }

    private void requireSameFiles(Path golden) throws IOException {
        Path folder =
                base.resolve(Files.readString(golden.resolve("directory.txt")).strip());
        for (String part : List.of("files", "bestPacMan", "bestObjectives")) {
            Path ours = part.equals("files") ? folder : folder.resolve(part);
            try (Stream<Path> files = Files.list(golden.resolve(part))) {
                List<Path> expected = files.toList();
                assertThat(expected).isNotEmpty();
                expected.forEach(file -> requireSame(ours.resolve(file.getFileName()), file));
            }
        }
    }

    private static void requireSame(Path ours, Path golden) {
        assertThat(ours).hasSameTextualContentAs(golden).hasSameBinaryContentAs(golden);
    }
}
