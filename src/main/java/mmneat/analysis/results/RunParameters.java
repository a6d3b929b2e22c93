package mmneat.analysis.results;

import com.fasterxml.jackson.core.type.TypeReference;
import com.fasterxml.jackson.dataformat.javaprop.JavaPropsMapper;
import com.fasterxml.jackson.dataformat.javaprop.JavaPropsSchema;
import java.io.IOException;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import mmneat.experiment.FileTrouble;
import mmneat.experiment.UserError;

/** The saved parameters of a run: ours, or the original's, whose lines {@code name:value} are properties as well. */
public final class RunParameters {

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

    /** All parameters by name; none without a folder or without a file in it. */
    public static Map<String, String> read(Optional<Path> folder) {
        Optional<Path> file = folder.flatMap(RunParameters::file);
        if (file.isEmpty()) {
            return Map.of();
        }
        try (Reader reader = Files.newBufferedReader(file.get())) {
            return new JavaPropsMapper()
                    .readerFor(new TypeReference<Map<String, String>>() {})
                    .with(JavaPropsSchema.emptySchema().withoutPathSeparator())
                    .readValue(reader);
        } catch (IOException e) {
            throw new UserError(file.get() + ": cannot be read: " + FileTrouble.reason(e), e);
        }
    }
}
