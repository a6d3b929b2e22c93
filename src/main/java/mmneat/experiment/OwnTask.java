package mmneat.experiment;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.util.Map;
import java.util.function.Supplier;
import mmneat.evolution.Task;

/**
 * A task of the user's own, in a class of another jar: {@code jar=FILE task=CLASS}.
 *
 * <p>The class implements {@link Task} and has a public constructor without arguments, or one with a
 * {@code Map<String, String>} that is given all parameters {@code task.NAME=VALUE} under their {@code NAME}.
 */
final class OwnTask {

    /** What the names of a task's own parameters begin with. */
    static final String PREFIX = "task.";

    private OwnTask() {}

    /**
     * Makes tasks of the named class, each for one thread.
     *
     * @param className full name of the class
     * @param jar a jar or a folder of classes; empty: the class is on the class path
     * @throws UserError if there is no such task
     */
    static Supplier<Task> factory(String className, String jar, Map<String, String> parameters) {
        Class<? extends Task> type = new OwnClasses(jar).find("task", className, Task.class);
        Supplier<Task> factory = () -> instance(type, parameters);
        factory.get();
        return factory;
    }

    private static Task instance(Class<? extends Task> type, Map<String, String> parameters) {
        String name = "task=" + type.getName();
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
            throw new UserError(name + ": cannot be made: " + e.getCause(), e);
        } catch (ReflectiveOperationException e) {
            throw new UserError(
                    name + ": needs a public constructor without arguments or with a Map<String, String>", e);
        }
    }
}
