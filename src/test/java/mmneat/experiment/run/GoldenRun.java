package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import mmneat.GoldenData;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;

/**
 * A recorded run of the original: its command line and the files that it wrote.
 *
 * @param folder with {@code command.txt}, {@code directory.txt} and the recorded files
 */
record GoldenRun(Path folder) {

    /** The words of the recorded command line; its results go to {@code base}, its input files are the golden data. */
    Stream<String> commandLine(Path base) throws IOException {
        Path locations = GoldenData.folder("ghost-locations").resolve("PowerPillToGhostLocationMapping.txt");
        return Arrays.stream(
                        Files.readString(folder.resolve("command.txt")).strip().split(" "))
                .map(word -> word.startsWith("base:") ? "base:" + base : word)
                .map(word -> word.startsWith("mazePowerPillGhostMapping:")
                        ? "mazePowerPillGhostMapping:" + locations
                        : word);
    }

    /** The same for runs 0 to {@code runs - 1}, all at the same time, each with its number as seed. */
    Stream<String> besideOthers(Path base, int runs) throws IOException {
        Stream<String> common =
                commandLine(base).filter(word -> !word.startsWith("runNumber:") && !word.startsWith("randomSeed:"));
        return Stream.concat(common, Stream.of("runs=" + runs, "threads=" + runs));
    }

    /** Carries out a command line; every run must be completed. */
    static void run(Stream<String> words) throws InterruptedException {
        ParameterReader reader = new ParameterReader(ParameterCatalogue.load());
        ExperimentPlan plan = ExperimentPlan.of(reader.read(words.toList()).parameters());
        assertThat(new ExperimentRunner(plan).run())
                .allSatisfy(outcome ->
                        assertThat(outcome.isComplete()).as(outcome.message()).isTrue());
    }

    /** Compares each recorded file with the one that our run wrote below {@code base}. */
    void requireSameFiles(Path base) throws IOException {
        Path ours =
                base.resolve(Files.readString(folder.resolve("directory.txt")).strip());
        for (String part : List.of("files", "bestPacMan", "bestObjectives")) {
            Path counterparts = part.equals("files") ? ours : ours.resolve(part);
            try (Stream<Path> files = Files.list(folder.resolve(part))) {
                List<Path> expected = files.toList();
                assertThat(expected).isNotEmpty();
                expected.forEach(file -> requireSame(counterparts.resolve(file.getFileName()), file));
            }
        }
    }

    static void requireSame(Path ours, Path golden) {
        assertThat(ours).hasSameTextualContentAs(golden).hasSameBinaryContentAs(golden);
    }
}
