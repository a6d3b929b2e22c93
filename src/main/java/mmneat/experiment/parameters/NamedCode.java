package mmneat.experiment.parameters;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import mmneat.experiment.UserError;

/**
 * The check that the command line allows the classes that the parameters name. It runs nothing of them; {@link
 * OwnClasses} loads them after this check.
 *
 * <p>A parameter file may come from another person, for example with the folder of a run. A class that only such a file
 * names must not be executed. A class is allowed in two cases. First, the command line gives {@code jar=}, also with an
 * empty value. Second, no jar is named at all, so that the class can only be on the class path, and the command line
 * itself gives the parameter that names the class.
 */
public final class NamedCode {

    private final Parameters parameters;
    private final Map<String, String> commandLine;

    /** @param commandLine the words of the command line by name */
    NamedCode(Parameters parameters, Map<String, String> commandLine) {
        this.parameters = parameters;
        this.commandLine = commandLine;
    }

    /**
     * Makes sure that the command line allows all code that is loaded.
     *
     * @param isGame whether the task is Ms. Pac-Man, not a task of the user's own
     * @param forGames whether networks only play, so that the classes of the evolution are not loaded and not checked
     * @throws UserError naming the parameter that asks for code, and how to allow it
     */
    void requireAllowed(boolean isGame, boolean forGames) {
        ofGames(parameters, isGame).forEach(this::requireAllowed);
        if (!forGames) {
            // A network that plays brings the name of its activation function along: OwnActivation.requireBound.
            requireAllowed("activation", parameters.text("activation"));
            requireAllowed("mutations", parameters.text("mutations"));
            requireAllowed("crossover", ownChoice(parameters, "crossover"));
            requireAllowed("selection", parameters.text("selection"));
        }
    }

    /**
     * Whether the networks of a run play only with classes of the user's own that no jar holds, but the class path.
     *
     * @param isGame whether the task is Ms. Pac-Man, not a task of the user's own
     */
    public static boolean isOnClassPath(Parameters parameters, boolean isGame) {
        return parameters.text("jar").isEmpty()
                && Stream.concat(
                                ofGames(parameters, isGame).values().stream(), Stream.of(parameters.text("activation")))
                        .anyMatch(names -> !names.isBlank());
    }

    /** The parameters that name classes which a network needs to play, with the names of the user's own classes. */
    private static Map<String, String> ofGames(Parameters parameters, boolean isGame) {
        if (!isGame) {
            return Map.of("task", parameters.text("task"));
        }
        Map<String, String> named = new LinkedHashMap<>();
        named.put("ownSensors", parameters.text("ownSensors"));
        named.put("objectives", ownObjectives(parameters));
        named.put("ghostTeam", ownChoice(parameters, "ghostTeam"));
        if (parameters.integer("multitaskModes") > 1) {
            named.put("pacmanMultitaskScheme", ownChoice(parameters, "pacmanMultitaskScheme"));
        }
        return named;
    }

    /** The value if it is the name of a class of the user's own, else nothing. */
    private static String ownChoice(Parameters parameters, String name) {
        String value = parameters.text(name);
        Parameter parameter = parameters.catalogue().require(name);
        return parameter.choices().contains(value) ? "" : value;
    }

    private static String ownObjectives(Parameters parameters) {
        return OwnClasses.names("objectives", parameters.text("objectives")).stream()
                .filter(name -> !ObjectiveParameter.isRecorded(name))
                .collect(Collectors.joining(","));
    }

    private void requireAllowed(String classes, String names) {
        String jar = parameters.text("jar");
        boolean isNamed = commandLine.containsKey("jar") || commandLine.containsKey(classes) && jar.isEmpty();
        if (!names.isBlank() && !isNamed) {
            String file = commandLine.getOrDefault("config", "the file");
            throw refusal(file + ": " + classes + "=" + names, jar);
        }
        requireNoTypingError(classes, names, jar);
    }

    /**
     * The refusal of code that the command line does not allow.
     *
     * @param code the file that names it, the parameter and the class
     * @param jar the jar that the file names; empty if it names none
     */
    static UserError refusal(String code, String jar) {
        return new UserError(code + " is code "
                + (jar.isEmpty() ? "from a jar that the file does not name" : "from jar=" + jar)
                + ", and code is loaded only if the command line names its jar; if you trust it, give jar="
                + (jar.isEmpty() ? "FILE" : jar) + " on the command line"
                + (jar.isEmpty() ? " (jar= if it is on the class path)" : ""));
    }

    /** A name without a package is more likely a choice that is spelled wrong than a class of the user's own. */
    private void requireNoTypingError(String name, String value, String jar) {
        Parameter parameter = parameters.catalogue().require(name);
        boolean isOpenChoice = !value.isEmpty() && !parameter.choices().isEmpty();
        if (isOpenChoice && !value.contains(".") && jar.isEmpty() && !new OwnClasses("").has(value)) {
            throw parameter.badValue(value);
        }
    }
}
