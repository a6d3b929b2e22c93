package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import mmneat.GoldenData;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Command lines beyond the sixteen published ones write the original's files, byte for byte: golden/runs-options. */
@Tag("conformance")
class GoldenOptionRunsConformanceTest {

    @TempDir
    Path base;

    static List<String> runs() throws IOException {
        try (Stream<Path> folders = Files.list(GoldenData.folder("runs-options"))) {
            List<String> names = folders.filter(Files::isDirectory)
                    .map(folder -> folder.getFileName().toString())
                    .sorted()
                    .toList();
            assertThat(names).isNotEmpty();
            return names;
        }
    }

    @ParameterizedTest
    @MethodSource("runs")
    void commandLine_writesTheOriginalsFiles(String name) throws Exception {
        GoldenRun golden = new GoldenRun(GoldenData.folder("runs-options").resolve(name));
        GoldenRun.run(golden.commandLine(base));
        golden.requireSameFiles(base);
    }

    @ParameterizedTest
    @MethodSource("runs")
    void runBesideOthers_writesTheOriginalsFiles(String name) throws Exception {
        GoldenRun golden = new GoldenRun(GoldenData.folder("runs-options").resolve(name));
        GoldenRun.run(golden.besideOthers(base, 4));
        golden.requireSameFiles(base);
    }
}
