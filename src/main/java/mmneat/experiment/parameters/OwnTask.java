package mmneat.experiment.parameters;

import java.lang.reflect.Constructor;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import mmneat.evolution.CheckedTask;
import mmneat.evolution.Task;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;

/**
 * A user's task, in a class of another jar: {@code jar=FILE task=CLASS}.
 *
 * <p>The class implements {@link Task} and has a public constructor without arguments, or one with a {@code Map<String,
 * String>} that receives all parameters {@code task.NAME=VALUE} by their {@code NAME}.
 */
public final class OwnTask {

    /** The prefix of the parameters of a user's task. */
    public static final String PREFIX = "task.";

    /** A network of a million neurons takes about 100 MB; a population of them exceeds every memory. */
    private static final int MOST_POLICY_NEURONS = 1_000_000;

    private OwnTask() {}

    /**
     * Returns a factory of tasks of the named class, each for one thread.
     *
     * @param className full name of the class
     * @param jar a jar or a folder of classes; empty: the class is on the class path
     * @throws UserError if there is no such class or it is not a valid task
     */
    static Supplier<Task> factory(String className, String jar, Map<String, String> parameters) {
        Class<? extends Task> type = new OwnClasses(jar).find("task", className, Task.class);
        requireShape("task=" + className, instance(type, parameters));
        return () -> CheckedTask.of(instance(type, parameters));
    }

    /** Checks that the task has inputs, outputs and objectives, and that no method fails. */
    private static void requireShape(String task, Task made) {
        List<String> objectives = names(task + ": objectiveNames()", made::objectiveNames);
        if (objectives.isEmpty()) {
            throw new UserError(task + ": names no objective; objectiveNames() must give at least one");
        }
        double[] least = OwnClasses.ask(task + ": referencePoint()", made::referencePoint);
        if (least.length != objectives.size()) {
            throw new UserError(task + ": referencePoint() must give " + objectives.size()
                    + " numbers, one for each objective, gives " + least.length);
        }
        if (Arrays.stream(least).anyMatch(score -> !Double.isFinite(score))) {
            throw new UserError(task + ": referencePoint() must give finite numbers, gives " + Arrays.toString(least));
        }
        List<String> labels = names(task + ": inputLabels()", made::inputLabels);
        int inputs = OwnClasses.ask(task + ": inputs()", made::inputs);
        if (labels.isEmpty() || inputs != labels.size()) {
            throw new UserError(task + ": must have at least one input and a label for each, has " + inputs
                    + " inputs and " + labels.size() + " labels; see inputLabels()");
        }
        names(task + ": otherScoreNames()", made::otherScoreNames);
        names(task + ": otherScoreLabels()", made::otherScoreLabels);
        OwnClasses.ask(task + ": isDeterministic()", made::isDeterministic);
        int neurons = OwnClasses.ask(task + ": policyNeuronsPerModule()", made::policyNeuronsPerModule);
        if (neurons < 1) {
            throw new UserError(task + ": policyNeuronsPerModule() must be at least 1, is " + neurons
                    + "; networks without outputs cannot be evolved");
        }
        if (neurons > MOST_POLICY_NEURONS) {
            throw new UserError(
                    task + ": policyNeuronsPerModule() must be at most " + MOST_POLICY_NEURONS + ", is " + neurons);
        }
        int trials = OwnClasses.ask(task + ": trials()", made::trials);
        if (trials < 1) {
            throw new UserError(task + ": trials() must be at least 1, is " + trials);
        }
    }

    /** Asks for names and checks them; they become parts of lines in logs, tables and scripts. */
    private static List<String> names(String method, Supplier<List<String>> asked) {
        List<String> names = OwnClasses.ask(method, asked);
        for (String name : names) {
            if (name == null) {
                throw new UserError(method + ": must not be null or contain null");
            }
            PlainText.require(method, name);
        }
        return names;
    }

    private static Task instance(Class<? extends Task> type, Map<String, String> parameters) {
        String name = "task=" + type.getName();
        OwnClasses.requirePublic(name, type);
        return OwnClasses.created(name, "without arguments or with a Map<String, String>", () -> {
            for (Constructor<?> constructor : type.getConstructors()) {
                if (constructor.getParameterCount() == 1 && constructor.getParameterTypes()[0] == Map.class) {
                    return (Task) constructor.newInstance(parameters);
                }
            }
            if (!parameters.isEmpty()) {
                throw new UserError(name + ": takes no parameters, so " + PREFIX
                        + parameters.keySet().iterator().next() + " is unknown (its class has no public constructor"
                        + " with a Map<String, String>)");
            }
            return type.getConstructor().newInstance();
        });
    }
}
