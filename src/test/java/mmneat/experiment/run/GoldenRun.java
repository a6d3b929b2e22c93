package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import mmneat.GoldenData;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;

/**
 * A recorded run of the original: its command line and the files that it wrote.
 *
 * @param folder with {@code command.txt}, {@code directory.txt} and the recorded files
 */
public record GoldenRun(Path folder) {

    /** The words of the recorded command line; its results go to {@code base}, its input files are the golden data. */
    public Stream<String> commandLine(Path base) throws IOException {
        Path locations = GoldenData.folder("ghost-locations").resolve("PowerPillToGhostLocationMapping.txt");
        return Arrays.stream(
                        Files.readString(folder.resolve("command.txt")).strip().split(" "))
                .map(word -> word.startsWith("base:") ? "base:" + base : word)
                .map(word -> word.startsWith("mazePowerPillGhostMapping:")
                        ? "mazePowerPillGhostMapping:" + locations
                        : word);
    }

    /** As {@link #commandLine}, for runs 0 to {@code runs - 1} in parallel, each with its number as seed. */
    Stream<String> besideOthers(Path base, int runs) throws IOException {
        Stream<String> common =
                commandLine(base).filter(word -> !word.startsWith("runNumber:") && !word.startsWith("randomSeed:"));
        return Stream.concat(common, Stream.of("runs=" + runs, "threads=" + runs));
    }

    /** Executes a command line, and checks that every run is completed. */
    public static void run(Stream<String> words) throws InterruptedException {
        ParameterReader reader = new ParameterReader(ParameterCatalogue.load());
        ExperimentPlan plan = ExperimentPlan.of(reader.read(words.toList()).parameters());
        assertThat(new ExperimentRunner(plan).run())
                .allSatisfy(outcome ->
                        assertThat(outcome.isComplete()).as(outcome.message()).isTrue());
    }

    /** Compares each recorded file with that of our run below {@code base}. */
    void requireSameFiles(Path base) throws IOException {
        counterparts(base).forEach((recorded, ours) -> requireSame(ours, recorded));
    }

    /** Replaces each recorded file by that of our run below {@code base}. */
    public void replaceFiles(Path base) throws IOException {
        for (Map.Entry<Path, Path> file : counterparts(base).entrySet()) {
            Files.copy(file.getValue(), file.getKey(), StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** Returns our run's file for each recorded file. */
    private Map<Path, Path> counterparts(Path base) throws IOException {
        Path ours =
                base.resolve(Files.readString(folder.resolve("directory.txt")).strip());
        Map<Path, Path> counterparts = new TreeMap<>();
        for (String part : List.of("files", "bestPacMan", "bestObjectives")) {
            Path oursOfPart = part.equals("files") ? ours : ours.resolve(part);
            try (Stream<Path> files = Files.list(folder.resolve(part))) {
                List<Path> recorded = files.toList();
                assertThat(recorded).isNotEmpty();
                recorded.forEach(file -> counterparts.put(file, oursOfPart.resolve(file.getFileName())));
            }
        }
        return counterparts;
    }

    static void requireSame(Path ours, Path golden) {
        assertThat(ours).hasSameTextualContentAs(golden).hasSameBinaryContentAs(golden);
    }
}
