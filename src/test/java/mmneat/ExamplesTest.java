package mmneat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The example programs run, are short, and are printed unchanged in README.md, docs/libraries.md or docs/extend.md.
 */
class ExamplesTest {

    private static final Path PROJECT =
            Path.of(System.getProperty("basedir", "")).toAbsolutePath();
    private static final Path EXAMPLES = PROJECT.resolve("src/examples/java");
    private static final int MOST_LINES = 25;

    /** Evolution with modules, selection alone, a controller, a sensor and a division. */
    private static final List<String> FIRST_PROGRAMS = List.of("Xor", "Zdt1", "Careful", "NearExit", "LateGame");

    /** Surefire starts the tests from a jar that refers to the class path. */
    private static final String CLASS_PATH =
            System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Xor | Correctness: 0\\.9\\d+",
                "Zdt1 | (\\[-?[\\d.E-]+, -?[\\d.E-]+]\\R){100}",
                "Careful | (?s).*9\t\\d+\\R.*",
                "NearExit | (?s).*results.near-exit.2M0.*",
                "Sine | (?s).*results.sine.2M0.*",
                "LateGame | (?s).*results.late-game.MT20.*",
                "Survival | (?s).*results.survival.2M0.*",
                "TwoChasers | (?s).*results.chasers.2M0.*",
                "WeightDecay | (?s).*results.decay.2M0.*",
                "AverageWeights | (?s).*results.average.2M0.*",
                "BestSum | (?s).*results.best-sum.2M0.*",
            })
    void example_runs(String name, String output) throws Exception {
        String path = Arrays.stream(CLASS_PATH.split(File.pathSeparator))
                .map(place -> Path.of(place).toAbsolutePath().toString())
                .collect(Collectors.joining(File.pathSeparator));
        ProgramRun run = ProgramRun.java(folder, "-XX:+UseSerialGC", "-cp", path, name);
        assertThat(run.exitCode()).as(run.errors()).isZero();
        assertThat(run.output().strip() + System.lineSeparator()).matches(output + "\\R?");
    }

    @Test
    void examples_areShort_andArePrintedInTheDocuments() throws IOException {
        String readme = document("README.md");
        String others = document("docs/libraries.md") + document("docs/extend.md");
        List<Path> files;
        try (Stream<Path> found = Files.list(EXAMPLES)) {
            files = found.sorted().toList();
        }
        assertThat(files).hasSizeGreaterThanOrEqualTo(10);
        for (Path file : files) {
            String code = Files.readString(file).replace("\r\n", "\n");
            assertThat(code.lines().count()).as(file.toString()).isLessThanOrEqualTo(MOST_LINES);
            assertThat(readme + others).contains("```java\n" + code + "```\n");
        }
        assertThat(readme).as("a first program on the first page").contains("```java\n");
        assertThat(readme)
                .as("the first programs, each with the command that runs it")
                .contains(FIRST_PROGRAMS.stream()
                        .map(name -> "`scripts/example " + name + "`")
                        .toList());
    }

    private static String document(String name) throws IOException {
        return Files.readString(PROJECT.resolve(name)).replace("\r\n", "\n");
    }
}
