package mmneat.analysis.results;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.PropertiesFile;
import mmneat.experiment.store.RunLayout;

/** The saved parameters of a run: ours, or the original's, whose lines {@code name:value} are properties as well. */
public final class RunParameters {

    /** What others read as numbers. */
    private static final List<String> WHOLE_NUMBERS = List.of("runNumber", "startingModes", "multitaskModes");

    private static final List<String> NUMBERS = List.of("mmdRate");

    private RunParameters() {}

    /**
     * All parameters by name; none without a folder or without a file in it.
     *
     * @throws UserError if the file cannot be read, or one that has to be a number is none
     */
    public static Map<String, String> read(Optional<Path> folder) {
        Optional<Path> file = folder.flatMap(RunLayout::parametersIn);
        if (file.isEmpty()) {
            return Map.of();
        }
        Map<String, String> parameters = PropertiesFile.read(file.get());
        WHOLE_NUMBERS.forEach(name -> PropertiesFile.requireWholeNumber(file.get(), parameters, name));
        NUMBERS.forEach(name -> PropertiesFile.requireNumber(file.get(), parameters, name));
        return parameters;
    }
}
