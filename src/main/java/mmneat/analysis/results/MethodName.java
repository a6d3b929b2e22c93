package mmneat.analysis.results;

import java.util.Locale;
import java.util.Map;

/** What methods and versions of the task are called: in commands and folders, in the paper, and by the original's parameters. */
public final class MethodName {

    private MethodName() {}

    /** The paper's name: MM(D) for MMD, otherwise the same. */
    public static String paper(String method) {
        return method.equals("MMD") ? "MM(D)" : method;
    }

    /**
     * The method that a run's parameters amount to, as the commands call it, or an empty text if it was not published.
     *
     * @param parameters the run's parameters, by the original's names; missing ones have their defaults
     */
    static String of(Map<String, String> parameters) {
        int startingModes = Integer.parseInt(parameters.getOrDefault("startingModes", "1"));
        int multitaskModes = Integer.parseInt(parameters.getOrDefault("multitaskModes", "1"));
        double duplication = Double.parseDouble(parameters.getOrDefault("mmdRate", "0"));
        if (multitaskModes > 1) {
            return version(parameters).equals("blended") ? "MT" + multitaskModes : "MT";
        }
        if (duplication > 0) {
            return startingModes == 1 ? "MMD" : "";
        }
        return startingModes + "M";
    }

    /** A version of the task as a heading, or an empty text for a task of the user's own. */
    public static String title(String version) {
        return version.isEmpty()
                ? ""
                : version.substring(0, 1).toUpperCase(Locale.ROOT) + version.substring(1) + " task";
    }

    /** The version of the task, or an empty text for a task of the user's own. */
    public static String version(Map<String, String> parameters) {
        String task = parameters.getOrDefault("task", "");
        String name = task.substring(task.lastIndexOf('.') + 1);
        return switch (name) {
            case "blended", "interleaved", "isolated" -> name;
            case "MsPacManTask" ->
                parameters.getOrDefault("imprisonedWhileEdible", "false").equalsIgnoreCase("true")
                        ? "interleaved"
                        : "blended";
            case "MsPacManPillsVsEdibleFromCornersMultitask" -> "isolated";
            default -> "";
        };
    }
}
