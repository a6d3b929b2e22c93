package mmneat.experiment.parameters;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import mmneat.experiment.UserError;

/**
 * The sixteen published experiments: what the paper sets for each task and method, from
 * {@code configs/<task>/<method>.properties}. Source: docs/specification/evolution.md, section 9.
 */
public final class PublishedConfigurations {

    /** The parameters in which the methods of a task differ. */
    static final List<String> NAMES_OF_METHODS =
            List.of("startingModes", "mmdRate", "multitaskModes", "pacmanMultitaskScheme");

    /** The parameters in which the tasks differ. */
    static final List<String> NAMES_OF_TASKS = List.of("imprisonedWhileEdible", "removePillsNearPowerPills");

    /** The methods of each task, in the paper's order. */
    private static final Map<String, List<String>> METHODS = methods();

    private PublishedConfigurations() {}

    private static Map<String, List<String>> methods() {
        Map<String, List<String>> methods = new LinkedHashMap<>();
        methods.put("blended", List.of("1M", "2M", "3M", "MMD", "MT2", "MT3"));
        methods.put("interleaved", List.of("1M", "2M", "3M", "MMD", "MT"));
        methods.put("isolated", List.of("1M", "2M", "3M", "MMD", "MT"));
        return methods;
    }

    /** blended, interleaved, isolated. */
    public static List<String> tasks() {
        return List.copyOf(METHODS.keySet());
    }

    /** The methods with which the task was published. */
    public static List<String> methodsOf(String task) {
        return METHODS.get(task);
    }

    /**
     * What the paper sets, besides the task and the method, which the files name so that they can be given as {@code config=}.
     *
     * @throws UserError if the task was not published with this method
     */
    static Map<String, String> settings(String task, String method) {
        if (!METHODS.get(task).contains(method)) {
            throw new UserError("method=" + method + " does not go with task=" + task + "; its methods are "
                    + String.join(", ", METHODS.get(task)));
        }
        String resource = "/configs/" + task + "/" + method + ".properties";
        try (InputStream stream = PublishedConfigurations.class.getResourceAsStream(resource)) {
            Map<String, String> settings = PropertiesFile.read(new InputStreamReader(stream, StandardCharsets.UTF_8));
            settings.keySet().removeAll(Set.of("task", "method"));
            return settings;
        } catch (IOException e) {
            throw new UncheckedIOException("the packed file " + resource + " cannot be read", e);
        }
    }

    /** What a method means for a task of somebody's own, of which nothing was published. */
    static Map<String, String> methodAlone(String method) {
        return switch (method) {
            case "1M" -> Map.of();
            case "2M" -> Map.of("startingModes", "2");
            case "3M" -> Map.of("startingModes", "3");
            case "MMD" -> Map.of("mmdRate", "0.1");
            default ->
                throw new UserError("method=" + method + " needs a human-specified task division, which only"
                        + " the tasks " + String.join(", ", tasks()) + " have");
        };
    }
}
