package mmneat.experiment;

import java.io.File;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
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
        Class<? extends Task> type = load(className, jar);
        Supplier<Task> factory = () -> instance(type, parameters);
        factory.get();
        return factory;
    }

    private static Class<? extends Task> load(String className, String jar) {
        ClassLoader loader = OwnTask.class.getClassLoader();
        if (!jar.isEmpty()) {
            Path file = Path.of(jar);
            if (!Files.isReadable(file)) {
                throw new UserError("jar=" + jar + ": there is no such file that can be read");
            }
            // Stays open as long as the program runs: the task may load its classes at any time.
            loader = new URLClassLoader(new URL[] {url(file.toFile())}, loader);
        }
        try {
            return Class.forName(className, true, loader).asSubclass(Task.class);
        } catch (ClassNotFoundException e) {
            throw new UserError(
                    "task=" + className + ": there is no such class"
                            + (jar.isEmpty() ? "; name its jar with jar=FILE" : " in " + jar),
                    e);
        } catch (ClassCastException e) {
            throw new UserError("task=" + className + ": the class must implement " + Task.class.getName(), e);
        } catch (LinkageError e) {
            throw new UserError("task=" + className + ": the class cannot be loaded: " + e, e);
        }
    }

    private static URL url(File file) {
        try {
            return file.toURI().toURL();
        } catch (MalformedURLException e) {
            throw new UserError("jar=" + file + ": not the name of a file", e);
        }
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
