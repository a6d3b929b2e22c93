package mmneat.experiment.store;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.OwnTask;
import mmneat.experiment.parameters.Parameter;
import mmneat.experiment.parameters.Parameters;
import mmneat.experiment.parameters.PropertiesFile;
import mmneat.experiment.parameters.PublishedTask;
import mmneat.experiment.parameters.Tasks;
import mmneat.mspacman.TaskVersion;

/**
 * The file {@code parameters.properties} in a run's folder. It has all values needed to repeat the run and can be used
 * as {@code config=FILE}.
 */
public final class RunParametersFile {

    /** Parameters of the command that are not properties of the run. */
    private static final Set<String> NOT_OF_THE_RUN =
            Set.of("runs", "run", "config", "quiet", "threads", "checkpointEvery");

    /** The parameters that may differ when a run is continued: paths and the number of generations. */
    private static final Set<String> MAY_CHANGE =
            Set.of("base", "saveTo", "jar", Tasks.GHOST_LOCATIONS, "maxGens", "method", "stopAt", "keepScores");

    private static final Set<String> FOLLOW_FROM_OTHERS = Set.of("method", "jar");

    private final Path directory;
    private final Path file;

    public RunParametersFile(Path directory) {
        this.directory = directory;
        file = directory.resolve(RunLayout.PARAMETERS);
    }

    public boolean exists() {
        return Files.exists(file);
    }

    public void write(Parameters parameters) throws IOException {
        String text = PropertiesFile.write(
                values(parameters), "All parameters of this run. To make it again: config=<this file>");
        DurableFiles.write(file, text.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * All values by name.
     *
     * @throws UserError if they cannot be read, or the run number is not a number
     */
    Map<String, String> read() {
        OrdinaryFiles.require(file);
        Map<String, String> values = PropertiesFile.read(file);
        PropertiesFile.requireWholeNumber(file, values, "runNumber");
        return values;
    }

    /**
     * Checks that the run was started with the same parameters.
     *
     * @throws UserError if not, naming those that differ
     */
    public void requireSame(Parameters parameters) {
        List<String> differing = differences(parameters);
        if (!differing.isEmpty()) {
            throw new UserError(sameName(read(), values(parameters))
                    .orElse(directory + " was begun with " + String.join(", ", differing)
                            + "; give the same to continue it, or another folder with base=FOLDER"));
        }
    }

    /** The parameters with which the run was started that differ from the given ones, as "mu=10 (now 100)". */
    public List<String> differences(Parameters parameters) {
        Map<String, String> saved = read();
        Map<String, String> asked = values(parameters);
        Set<String> names = new LinkedHashSet<>(asked.keySet());
        names.addAll(saved.keySet());
        List<String> differing = new ArrayList<>();
        for (String name : names) {
            String before = saved.get(name);
            String value = asked.get(name);
            // A parameter of the catalogue that one side lacks belongs to an older or newer version, or has no effect.
            boolean isComparable = before != null && value != null
                    || parameters.catalogue().find(name).isEmpty();
            if (isComparable && !Objects.equals(before, value) && !MAY_CHANGE.contains(name)) {
                String now = value == null ? "not given" : value;
                differing.add((before == null ? "no " + name : name + "=" + before) + " (now " + now + ")");
            }
        }
        return differing;
    }

    /**
     * The mistake that two runs with different numbers have one folder: the name before the number ends in a digit, as
     * that of a hybrid does. Empty if the name or the number is the same.
     */
    private Optional<String> sameName(Map<String, String> saved, Map<String, String> asked) {
        String other = saved.getOrDefault("saveTo", "");
        String name = asked.getOrDefault("saveTo", "");
        String number = saved.getOrDefault("runNumber", "");
        String numberNow = asked.getOrDefault("runNumber", "");
        if (other.isEmpty() || name.isEmpty() || other.equals(name) || number.equals(numberNow)) {
            return Optional.empty();
        }
        return Optional.of(directory + " is run " + number + " of " + other + ", and run " + numberNow + " of " + name
                + " would have the same folder; give saveTo=" + name + "-");
    }

    /**
     * Returns every value that has an effect. The name of the method is left out unless it was given, because it
     * follows from the other values.
     */
    private static Map<String, String> values(Parameters parameters) {
        Map<String, String> values = new LinkedHashMap<>();
        for (Parameter parameter : parameters.catalogue().all()) {
            String name = parameter.name();
            boolean follows = FOLLOW_FROM_OTHERS.contains(name) && !parameters.isGiven(name);
            if (parameter.support() == Parameter.Support.YES && !NOT_OF_THE_RUN.contains(name) && !follows) {
                values.put(name, parameters.text(name));
            }
        }
        Optional<TaskVersion> version = PublishedTask.version(parameters);
        version.ifPresent(named -> values.put("task", named.label()));
        if (version.filter(TaskVersion.ISOLATED::equals).isPresent()) {
            values.put(Tasks.GHOST_LOCATIONS, RunLayout.GHOST_LOCATIONS);
        }
        parameters.ofOwnTask().forEach((name, value) -> values.put(OwnTask.PREFIX + name, value));
        return values;
    }
}
