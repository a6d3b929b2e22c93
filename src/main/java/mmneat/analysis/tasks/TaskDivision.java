package mmneat.analysis.tasks;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import mmneat.experiment.UserError;
import mmneat.mspacman.TaskVersion;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.modules.ModuleDivisions;
import mmneat.mspacman.sensors.Observation;

/**
 * A division of the game into subtasks, as a designer defines it. Each subtask is a predicate on states of the game: it
 * is to be done in the states in which the predicate holds.
 *
 * @param name the name, as written by users
 * @param tasks the predicates, at least two, at most 31
 */
public record TaskDivision(String name, List<TaskPredicate> tasks) {

    private static final int MOST_TASKS = 31;

    private static final Map<String, TaskPredicate> KNOWN = known();

    public TaskDivision {
        tasks = List.copyOf(tasks);
        if (tasks.size() < 2 || tasks.size() > MOST_TASKS) {
            throw new IllegalArgumentException(
                    name + ": a division has 2 to " + MOST_TASKS + " tasks, not " + tasks.size());
        }
    }

    private static Map<String, TaskPredicate> known() {
        Map<String, TaskPredicate> known = new LinkedHashMap<>();
        add(known, new TaskPredicate("threats", observation -> observation.threats() > 0));
        add(known, new TaskPredicate("edible", observation -> observation.edibleGhosts() > 0));
        add(known, new TaskPredicate("pills", TaskDivision::arePillsLeft));
        add(known, new TaskPredicate("noPills", observation -> !arePillsLeft(observation)));
        return known;
    }

    private static void add(Map<String, TaskPredicate> known, TaskPredicate predicate) {
        known.put(predicate.name(), predicate);
    }

    private static boolean arePillsLeft(Observation observation) {
        return observation.pillsLeft() > 0 || observation.powerPillsLeft() > 0;
    }

    /** The names of single predicates. */
    public static List<String> predicateNames() {
        return List.copyOf(KNOWN.keySet());
    }

    /**
     * Returns the division that fits a version. For the isolated version: pills are left (eating pills), and no pills
     * are left (eating ghosts). For the others: a ghost outside the lair is a threat (fleeing), and a ghost is edible
     * (eating it).
     */
    public static TaskDivision usual(TaskVersion version) {
        return named(version == TaskVersion.ISOLATED ? "pills,noPills" : "threats,edible");
    }

    /**
     * Returns the division with a name.
     *
     * @param name two or more of {@link #predicateNames}, separated by commas; or the name of a division among modules,
     *     such as {@code AnyGhostEdible} ({@link ModuleDivisions#named}). Of such a division, each module is a subtask:
     *     it is to be done in the states in which the division chooses this module
     * @throws UserError if there is none
     */
    public static TaskDivision named(String name) {
        if (!name.contains(",")) {
            return ofModules(name);
        }
        List<TaskPredicate> tasks = new ArrayList<>();
        for (String part : name.split(",", -1)) {
            TaskPredicate predicate = KNOWN.get(part.strip());
            if (predicate == null) {
                throw new UserError("predicates=" + name + ": '" + part.strip() + "' is not one of "
                        + String.join(", ", KNOWN.keySet()));
            }
            if (tasks.contains(predicate)) {
                throw new UserError("predicates=" + name + ": '" + predicate.name() + "' is named twice");
            }
            tasks.add(predicate);
        }
        return new TaskDivision(name, tasks);
    }

    private static TaskDivision ofModules(String name) {
        ModuleDivision division;
        try {
            division = ModuleDivisions.named(name);
        } catch (IllegalArgumentException e) {
            throw new UserError(
                    "predicates=" + name + ": must be two or more of " + String.join(", ", KNOWN.keySet())
                            + ", separated by commas, or a division among modules such as AnyGhostEdible",
                    e);
        }
        List<TaskPredicate> tasks = new ArrayList<>();
        for (int module = 0; module < division.modules(); module++) {
            int ofTask = module;
            tasks.add(new TaskPredicate(name + "=" + module, observation -> division.module(observation) == ofTask));
        }
        return new TaskDivision(name, tasks);
    }

    /** The tasks that are to be done in a state, as bits in their order. */
    int tasksIn(Observation observation) {
        int bits = 0;
        for (int task = 0; task < tasks.size(); task++) {
            bits |= tasks.get(task).holds().test(observation) ? 1 << task : 0;
        }
        return bits;
    }
}
