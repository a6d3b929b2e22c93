package mmneat.analysis.results;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.PropertiesFile;

/** The saved parameters of a run: ours, or the original's, whose lines {@code name:value} are properties as well. */
public final class RunParameters {

    /** What others read as numbers. */
    private static final List<String> WHOLE_NUMBERS = List.of("runNumber", "startingModes", "multitaskModes");

    private static final List<String> NUMBERS = List.of("mmdRate");

    private RunParameters() {}

    /** The file of a run's parameters. */
    public static Optional<Path> file(Path folder) {
        Path ours = folder.resolve("parameters.properties");
        if (Files.exists(ours)) {
            return Optional.of(ours);
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.getFileName().toString().endsWith("_parameters.txt"))
                    .sorted()
                    .findFirst();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * All parameters by name; none without a folder or without a file in it.
     *
     * @throws UserError if the file cannot be read, or one that has to be a number is none
     */
    public static Map<String, String> read(Optional<Path> folder) {
        Optional<Path> file = folder.flatMap(RunParameters::file);
        if (file.isEmpty()) {
            return Map.of();
        }
        Map<String, String> parameters = PropertiesFile.read(file.get());
        WHOLE_NUMBERS.forEach(name -> PropertiesFile.requireWholeNumber(file.get(), parameters, name));
        NUMBERS.forEach(name -> PropertiesFile.requireNumber(file.get(), parameters, name));
        return parameters;
    }
}
