package mmneat.experiment.original;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import mmneat.GoldenData;
import mmneat.evolution.Evaluation;
import mmneat.evolution.SampleStatistics;
import mmneat.evolution.Task;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Summaries of two runs equal the original's: golden/logs. Both runs had the same seed. */
@Tag("conformance")
class RunSummariesConformanceTest {

    @TempDir
    Path base;

    private Path golden;

    @BeforeEach
    void summariseTwoEqualRuns() throws IOException {
        golden = GoldenData.folder("logs");
        for (int run : List.of(0, 1)) {
            Path folder = Files.createDirectory(base.resolve("MMD" + run));
            try (DirectoryStream<Path> files = Files.newDirectoryStream(golden, "P-MMD0_*")) {
                for (Path file : files) {
                    String name = file.getFileName().toString().replace("P-MMD0", "P-MMD" + run);
                    if (!name.contains("genHV")) {
                        Files.copy(file, folder.resolve(name));
                    }
                }
            }
        }
        new RunSummaries(base, "MMD", "P-MMD", new LabelsOfTheLogs(golden)).write(List.of(0, 1));
    }

    @Test
    void hypervolumes_equalTheOriginals() throws IOException {
        assertThat(base.resolve("MMD0/P-MMD0_parents_genHV.txt"))
                .hasSameTextualContentAs(golden.resolve("P-MMD0_parents_genHV.txt"));
        requireSame("P-MMDAVG_parents_genHV.txt");
    }

    /** The original had lost the last row of run 0; our summary includes it. */
    @Test
    void averages_equalTheOriginals_andHaveTheRowItLost() throws IOException {
        for (String name : List.of("P-MMDAVG_parents_log.txt", "P-MMDAVG_TWEANNData_log.txt")) {
            List<String> expected = Files.readAllLines(golden.resolve(name));
            List<String> lines = Files.readAllLines(base.resolve(name));
            assertThat(lines).hasSize(expected.size() + 1).startsWith(expected.toArray(String[]::new));
        }
    }

    @Test
    void scripts_equalTheOriginals() throws IOException {
        requireSame("P-MMDAll_parents_genHV.plot");
        requireSame("P-MMDAVG_parents_genHV.plot");
        requireSame("P-MMDAVG_parents_genScores.plot");
        requireSame("P-MMDAVG_TWEANNData_log.plot");
        requireSame("P-MMDAVG_Performance_log.plot");
    }

    /** The times of the second run are not recorded. For the first columns they follow from the means and variances. */
    @Test
    void variance_isThatOfTheSample() throws IOException {
        double[] times = numbers(
                Files.readAllLines(golden.resolve("P-MMD0_Performance_log.txt")).get(0));
        double[] averages = numbers(Files.readAllLines(golden.resolve("P-MMDAVG_Performance_log.txt"))
                .get(0));
        double first = times[1];
        double second = 2 * averages[2] - first;
        assertThat(SampleStatistics.varianceOf(first, second)).isEqualTo(averages[3]);
    }

    private void requireSame(String name) throws IOException {
        assertThat(Files.readString(base.resolve(name))).as(name).isEqualTo(Files.readString(golden.resolve(name)));
    }

    private static double[] numbers(String line) {
        return Arrays.stream(line.split("\t")).mapToDouble(Double::parseDouble).toArray();
    }

    /** Names of scores and inputs as the recorded scripts have them. */
    private record LabelsOfTheLogs(Path golden) implements Task {

        private static final int OBJECTIVES = 2;
        private static final int MODULE_USAGES = 6;

        @Override
        public List<String> objectiveNames() {
            return titles("P-MMD0_parents_log.plot", "P-MMD0_parents (.*)")
                    .limit(OBJECTIVES)
                    .toList();
        }

        @Override
        public List<String> otherScoreNames() {
            return titles("P-MMD0_parents_log.plot", "P-MMD0_parents (.*)")
                    .skip(OBJECTIVES)
                    .toList();
        }

        @Override
        public List<String> otherScoreLabels() {
            return titles("P-MMDAVG_parents_genScores.plot", "Average '(.*)' for MMD by Generation")
                    .skip(OBJECTIVES)
                    .toList();
        }

        @Override
        public List<String> inputLabels() {
            return titles("P-MMD0_TWEANNData_log.plot", "P-MMD0_TWEANNData (.*) Usage")
                    .skip(MODULE_USAGES)
                    .toList();
        }

        private Stream<String> titles(String script, String pattern) {
            Pattern title = Pattern.compile("set title \"" + pattern + "\"");
            try {
                return Files.readAllLines(golden.resolve(script)).stream()
                        .map(title::matcher)
                        .filter(Matcher::matches)
                        .map(matcher -> matcher.group(1));
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        @Override
        public int policyNeuronsPerModule() {
            return 1;
        }

        @Override
        public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
            throw new UnsupportedOperationException("only the names are wanted");
        }
    }
}
