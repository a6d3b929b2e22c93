package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import mmneat.GoldenData;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The sixteen published command lines write the original's files, byte for byte: golden/runs. So do the runs of
 * golden/logs, other options and another seed. In the compact data the isolated runs are this program's, with its own
 * ghost locations.
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
        GoldenRun golden = new GoldenRun(GoldenData.folder("runs").resolve(configuration));
        GoldenRun.run(golden.commandLine(base));
        golden.requireSameFiles(base);
    }

    @Test
    void runSideBySideWithOthers_writesTheOriginalsFiles() throws Exception {
        GoldenRun golden = new GoldenRun(GoldenData.folder("runs").resolve("OneLifeConflict-MMD"));
        GoldenRun.run(golden.besideOthers(base, 3));
        golden.requireSameFiles(base);
        assertThat(base.resolve("MMD2/OneLifeConflict-MMD2_parents_log.txt")).isNotEmptyFile();
    }

    @Test
    void runOfTheLogs_writesTheOriginalsFiles() throws Exception {
        Path golden = GoldenData.folder("logs");
        Stream<String> published =
                new GoldenRun(GoldenData.folder("runs").resolve("OneLifeConflict-MMD")).commandLine(base);
        List<String> others = List.of("randomSeed:3", "maxGens:3", "mu:6", "trials:2", "log:P-MMD");
        List<String> replaced =
                others.stream().map(word -> word.split(":")[0] + ":").toList();
        GoldenRun.run(Stream.concat(
                published.filter(word -> replaced.stream().noneMatch(word::startsWith)), others.stream()));
        Path folder = base.resolve("MMD0");
        try (Stream<Path> files = Files.list(golden)) {
            files.filter(file -> file.getFileName()
                            .toString()
                            .matches("P-MMD0_(parents|child|TWEANNData|ModeUsage|Mutations|Lineage).*"))
                    .filter(file -> !file.toString().contains("genHV"))
                    .forEach(file -> GoldenRun.requireSame(folder.resolve(file.getFileName()), file));
        }
        GoldenRun.requireSame(
                folder.resolve("P-MMD0_Performance_log.plot"), golden.resolve("P-MMD0_Performance_log.plot"));
        GoldenRun.requireSame(folder.resolve("bestPacMan/score.txt"), golden.resolve("bestPacMan_score.txt"));
        GoldenRun.requireSame(folder.resolve("bestObjectives/score0.txt"), golden.resolve("bestObjectives_score0.txt"));
        GoldenRun.requireSame(folder.resolve("bestObjectives/score1.txt"), golden.resolve("bestObjectives_score1.txt"));
        GoldenRun.requireSame(
                folder.resolve("combiningCrossoverMapping.txt"), golden.resolve("combiningCrossoverMapping.txt"));
    }
}
