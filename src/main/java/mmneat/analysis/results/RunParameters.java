package mmneat.analysis.results;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import mmneat.experiment.FileErrors;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.OriginalParameterFile;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.PropertiesFile;
import mmneat.experiment.store.RunLayout;

/** The saved parameters of a run, ours or the original's. */
public final class RunParameters {

    /** Names of the parameters that must be whole numbers. */
    private static final List<String> WHOLE_NUMBERS = List.of("runNumber", "startingModes", "multitaskModes");

    private static final List<String> NUMBERS = List.of("mmdRate", "mmrRate");

    private RunParameters() {}

    private static Map<String, String> values(Path file) {
        if (file.endsWith(RunLayout.PARAMETERS)) {
            return PropertiesFile.read(file);
        }
        try {
            return OriginalParameterFile.of(Files.readAllLines(file, StandardCharsets.UTF_8), ParameterCatalogue.load())
                    .values();
        } catch (IOException e) {
            throw new UserError(file + ": cannot be read: " + FileErrors.reason(e), e);
        }
    }

    /**
     * All parameters by name; none without a folder or without a file in it.
     *
     * @throws UserError if the file cannot be read, or a parameter that must be a number is not one
     */
    public static Map<String, String> read(Optional<Path> folder) {
        Optional<Path> file = folder.flatMap(RunLayout::parametersIn);
        if (file.isEmpty()) {
            return Map.of();
        }
        Map<String, String> parameters = values(file.get());
        WHOLE_NUMBERS.forEach(name -> PropertiesFile.requireWholeNumber(file.get(), parameters, name));
        NUMBERS.forEach(name -> PropertiesFile.requireNumber(file.get(), parameters, name));
        return parameters;
    }
}
