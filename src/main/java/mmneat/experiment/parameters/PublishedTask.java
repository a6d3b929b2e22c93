package mmneat.experiment.parameters;

import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import mmneat.experiment.NearestName;
import mmneat.experiment.UserError;
import mmneat.mspacman.TaskVersion;

/**
 * Rules that determine from parameters which version of the Ms.&nbsp;Pac-Man task and which method a run has.
 * Parameters may name them as this program does ({@code task=blended}) or as the original does.
 */
public final class PublishedTask {

    private static final String GAME_CLASS = "MsPacManTask";
    private static final String ISOLATED_CLASS = "MsPacManPillsVsEdibleFromCornersMultitask";

    /** Parameters of {@link #NOT_OF_THE_EVOLUTION} groups that the results depend on nevertheless. */
    private static final Set<String> EVOLUTION_IN_OTHER_GROUPS =
            Set.of("mu", "maxGens", "crowding", "keepScores", "stopAt");

    /** Groups of parameters that do not change an evolution. */
    private static final Set<String> NOT_OF_THE_EVOLUTION =
            Set.of("Everyday", "Run control", "Post-evaluation and display");

    /** The parameters that experiments of other papers change: sensors, selection, module mutation, lives. */
    private static final Set<String> OF_OTHER_EXPERIMENTS = Set.of(
            "specific",
            "specificGhostProximityOrder",
            "specificGhostEdibleThreatSplit",
            "eTimeVsGDis",
            "ea",
            "mmrRate",
            "mmpRate",
            "fullMMRate",
            "pacmanLives",
            "pacManGainsLives");

    private PublishedTask() {}

    /**
     * Returns the version that checked parameters describe.
     *
     * @return empty for a user's task class
     * @throws UserError if the parameters name no task, or contradict each other
     */
    public static Optional<TaskVersion> version(Parameters parameters) {
        String task = parameters.text("task");
        List<String> published = TaskVersion.labels();
        if (task.isEmpty()) {
            throw new UserError("task is missing; give it as task=" + String.join("|", published));
        }
        boolean imprisoned = parameters.flag("imprisonedWhileEdible");
        Optional<TaskVersion> version = named(task, imprisoned);
        if (published.contains(task)) {
            if (task.equals(TaskVersion.BLENDED.label()) && imprisoned
                    || task.equals(TaskVersion.INTERLEAVED.label()) && !imprisoned) {
                throw new UserError("imprisonedWhileEdible=" + imprisoned + " contradicts task=" + task
                        + ": it is the difference between blended and interleaved; leave it out");
            }
        } else if (version.isEmpty() && !task.contains(".") && !parameters.isGiven("jar")) {
            throw new UserError("task=" + task + ": must be one of " + String.join(", ", published)
                    + ", or the name of a class of your own, in jar=FILE" + NearestName.suggestion(task, published));
        }
        return version;
    }

    /**
     * Returns the version that a run's parameters describe, if they name a task.
     *
     * @param parameters by name, as written in the run's folder; missing ones have their defaults
     * @return empty for a user's task class, or if no task is named
     */
    public static Optional<TaskVersion> version(Map<String, String> parameters) {
        String task = parameters.getOrDefault("task", "");
        return named(
                task.substring(task.lastIndexOf('.') + 1),
                parameters.getOrDefault("imprisonedWhileEdible", "false").equalsIgnoreCase("true"));
    }

    private static Optional<TaskVersion> named(String task, boolean imprisoned) {
        return switch (task) {
            case GAME_CLASS -> Optional.of(imprisoned ? TaskVersion.INTERLEAVED : TaskVersion.BLENDED);
            case ISOLATED_CLASS -> Optional.of(TaskVersion.ISOLATED);
            default -> TaskVersion.labelled(task);
        };
    }

    /**
     * Returns the method that the number of modules and the mutation rates define. The parameter {@code method} is not
     * read: runs of the original do not have it, and other parameters of a run may contradict it.
     *
     * @param parameters by name; missing ones have their defaults
     * @return its short name, such as {@code 2M}; empty for a combination without a name
     */
    public static Optional<String> method(Map<String, String> parameters) {
        int startingModes = Integer.parseInt(parameters.getOrDefault("startingModes", "1"));
        int multitaskModes = Integer.parseInt(parameters.getOrDefault("multitaskModes", "1"));
        boolean duplicates = Double.parseDouble(parameters.getOrDefault("mmdRate", "0")) > 0;
        boolean links = Double.parseDouble(parameters.getOrDefault("mmrRate", "0")) > 0;
        String groups = parameters.getOrDefault("moduleGroups", "");
        if (!groups.isEmpty()) {
            return links ? Optional.empty() : HybridMethod.name(groups, duplicates);
        }
        if (multitaskModes > 1) {
            return Optional.of(multitask(version(parameters), multitaskModes));
        }
        if (duplicates || links) {
            return startingModes == 1 && duplicates != links
                    ? Optional.of(duplicates ? "MMD" : "MMR")
                    : Optional.empty();
        }
        return Optional.of(startingModes + "M");
    }

    /**
     * Returns the parameters of a run that differ from those of the published experiment with the same version and
     * method. Parameters that do not change the evolution (files, seeds, threads) are not compared, nor are those that
     * the run does not name.
     *
     * @param version of the task
     * @param method a method with which the version was published
     * @param parameters of the run, by name
     * @return the published value of each parameter that differs, by name, in the order of the catalogue
     */
    public static Map<String, String> differences(TaskVersion version, String method, Map<String, String> parameters) {
        ParameterCatalogue catalogue = ParameterCatalogue.load();
        Parameters published = new ParameterReader(catalogue)
                .read(List.of("task=" + version.label(), "method=" + method))
                .parameters();
        Map<String, String> differences = new LinkedHashMap<>();
        for (Parameter parameter : catalogue.all()) {
            String name = parameter.name();
            String value = parameters.get(name);
            if (isOfTheEvolution(parameter) && value != null && !value.equals(published.text(name))) {
                differences.put(name, published.text(name));
            }
        }
        return differences;
    }

    /**
     * Returns the names of the parameters that have different values in some runs, in the order of the catalogue. The
     * same parameters as in {@link #differences} are compared. A run that does not name one has its default.
     *
     * @param runs the parameters of each run, by name; a run without any parameters is ignored
     */
    public static List<String> differing(List<Map<String, String>> runs) {
        return ParameterCatalogue.load().all().stream()
                .filter(PublishedTask::isOfTheEvolution)
                .filter(parameter -> runs.stream()
                                .filter(run -> !run.isEmpty())
                                .map(run -> run.getOrDefault(parameter.name(), parameter.defaultValue()))
                                .distinct()
                                .count()
                        > 1)
                .map(Parameter::name)
                .toList();
    }

    private static boolean isOfTheEvolution(Parameter parameter) {
        String name = parameter.name();
        return parameter.support() == Parameter.Support.YES
                && (!NOT_OF_THE_EVOLUTION.contains(parameter.group()) || EVOLUTION_IN_OTHER_GROUPS.contains(name))
                && !name.equals("task")
                && !name.equals(Tasks.GHOST_LOCATIONS);
    }

    /**
     * Whether a run whose values of these parameters differ from the published ones has another method, rather than the
     * published method with changed settings. That is so if one of them defines the method (number of modules, module
     * mutation) or is what experiments of other papers with the original changed (sensors, selection, lives). Reports
     * then do not present the run under the name of the published method.
     *
     * @param names names of the parameters that differ
     */
    public static boolean changesTheMethod(Collection<String> names) {
        return !Collections.disjoint(names, PublishedConfigurations.namesOfMethods())
                || !Collections.disjoint(names, OF_OTHER_EXPERIMENTS);
    }

    /**
     * Returns the name of the method of multitask networks, whose modules a division chooses. Versions with one
     * published division say {@code MT}. The blended version has two, of two and three modules, so its methods, and
     * those of a user's task, have the number of modules at the end: {@code MT2}, {@code MT3}.
     *
     * @param version of the task; empty for a user's task
     * @param modules modules of the networks
     */
    public static String multitask(Optional<TaskVersion> version, int modules) {
        boolean hasOneDivision = version.filter(TaskVersion.BLENDED::equals).isEmpty() && version.isPresent();
        return hasOneDivision ? "MT" : "MT" + modules;
    }
}
