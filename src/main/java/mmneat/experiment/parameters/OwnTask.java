package mmneat.experiment.parameters;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Supplier;
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
        Supplier<Task> factory = () -> instance(type, parameters);
        requireShape("task=" + className, factory.get());
        return factory;
    }

    /** Checks that the task has inputs, outputs and objectives. */
    private static void requireShape(String task, Task made) {
        List<String> objectives = made.objectiveNames();
        if (objectives == null || objectives.isEmpty()) {
            throw new UserError(task + ": names no objective; objectiveNames() must give at least one");
        }
        double[] least = made.referencePoint();
        if (least == null || least.length != objectives.size()) {
            throw new UserError(task + ": referencePoint() must give " + objectives.size()
                    + " numbers, one for each objective, gives " + (least == null ? 0 : least.length));
        }
        List<String> inputs = made.inputLabels();
        if (inputs == null || inputs.isEmpty() || made.inputs() != inputs.size()) {
            throw new UserError(task + ": must have at least one input and a label for each, has " + made.inputs()
                    + " inputs and " + (inputs == null ? 0 : inputs.size()) + " labels; see inputLabels()");
        }
        requireNames(task + ": objectiveNames()", objectives);
        requireNames(task + ": otherScoreNames()", made.otherScoreNames());
        requireNames(task + ": otherScoreLabels()", made.otherScoreLabels());
        requireNames(task + ": inputLabels()", inputs);
        if (made.policyNeuronsPerModule() < 1) {
            throw new UserError(task + ": policyNeuronsPerModule() must be at least 1, is "
                    + made.policyNeuronsPerModule() + "; networks without outputs cannot be evolved");
        }
        if (made.trials() < 1) {
            throw new UserError(task + ": trials() must be at least 1, is " + made.trials());
        }
    }

    /** Checks names, which become parts of lines in logs, tables and scripts. */
    private static void requireNames(String method, List<String> names) {
        if (names == null || names.stream().anyMatch(Objects::isNull)) {
            throw new UserError(method + ": must not be null or contain null");
        }
        names.forEach(name -> PlainText.require(method, name));
    }

    private static Task instance(Class<? extends Task> type, Map<String, String> parameters) {
        String name = "task=" + type.getName();
        OwnClasses.requirePublic(name, type);
        try {
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
        } catch (InvocationTargetException e) {
            throw new UserError(name + ": cannot be created: " + e.getCause(), e);
        } catch (ReflectiveOperationException e) {
            throw new UserError(
                    name + ": needs a public constructor without arguments or with a Map<String, String>", e);
        }
    }
}
