package mmneat.analysis.results;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import mmneat.experiment.TextFiles;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.OriginalParameterFile;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.PropertiesFile;
import mmneat.experiment.store.RunLayout;

/** The saved parameters of a run, ours or the original's. */
public final class RunParameters {

    /** Names of the parameters that must be whole numbers. */
    private static final List<String> WHOLE_NUMBERS =
            List.of("runNumber", "startingModes", "multitaskModes", "maxGens");

    private static final List<String> NUMBERS = List.of("mmdRate", "mmrRate");

    private RunParameters() {}

    private static Map<String, String> values(Path file) {
        if (file.endsWith(RunLayout.PARAMETERS)) {
            return PropertiesFile.read(file);
        }
        return OriginalParameterFile.of(TextFiles.lines(file), ParameterCatalogue.load())
                .values();
    }

    /**
     * All parameters by name; none without a folder or without a file in it.
     *
     * @throws UserError if the file cannot be read, names no task, or has a text for a number
     */
    public static Map<String, String> read(Optional<Path> folder) {
        Optional<Path> file = folder.flatMap(RunLayout::parametersIn);
        if (file.isEmpty()) {
            return Map.of();
        }
        Map<String, String> parameters = values(file.get());
        if (parameters.getOrDefault("task", "").isEmpty()) {
            throw new UserError(file.get() + ": " + (parameters.isEmpty() ? "is empty" : "does not name the task")
                    + "; restore it or leave the run out");
        }
        for (String name : WHOLE_NUMBERS) {
            PropertiesFile.requireWholeNumber(file.get(), parameters, name);
            if (parameters.getOrDefault(name, "").startsWith("-")) {
                throw new UserError(
                        file.get() + ": " + name + "=" + parameters.get(name) + ": must not be negative; restore it");
            }
        }
        NUMBERS.forEach(name -> PropertiesFile.requireNumber(file.get(), parameters, name));
        return parameters;
    }
}
