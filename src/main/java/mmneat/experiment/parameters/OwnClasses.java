package mmneat.experiment.parameters;

import java.lang.reflect.InvocationTargetException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import mmneat.experiment.UserError;

/** The classes of the user's own that parameters name: on the class path, or in {@code jar=FILE}. */
final class OwnClasses {

    private final ClassLoader loader;
    private final String jar;

    /**
     * The classes of a place.
     *
     * @param jar a jar or a folder of classes, which go after those of the class path; empty: these alone
     * @throws UserError if it cannot be read
     */
    OwnClasses(String jar) {
        this.jar = jar;
        ClassLoader ours = OwnClasses.class.getClassLoader();
        // Stays open as long as the program runs: a class may load others at any time.
        loader = jar.isEmpty() ? ours : new URLClassLoader(new URL[] {url(jar)}, ours);
    }

    private static URL url(String jar) {
        Path file = Path.of(jar);
        if (!Files.isReadable(file)) {
            throw new UserError("jar=" + jar + ": there is no such file that can be read");
        }
        try {
            return file.toUri().toURL();
        } catch (MalformedURLException e) {
            throw new UserError("jar=" + jar + ": not the name of a file", e);
        }
    }

    /**
     * The class of a name.
     *
     * @param parameter the parameter that names it, for messages
     * @param type what it has to be
     * @throws UserError if there is no such class
     */
    <T> Class<? extends T> find(String parameter, String className, Class<T> type) {
        String asked = parameter + "=" + className;
        try {
            // Nothing in the class runs before it is known to be of the type.
            return Class.forName(className, false, loader).asSubclass(type);
        } catch (ClassNotFoundException e) {
            throw new UserError(
                    asked + ": there is no such class"
                            + (jar.isEmpty() ? "; name its jar with jar=FILE" : " in " + jar),
                    e);
        } catch (ClassCastException e) {
            throw new UserError(
                    asked + ": the class must " + (type.isInterface() ? "implement " : "extend ") + type.getName(), e);
        } catch (LinkageError e) {
            throw new UserError(asked + ": the class cannot be loaded: " + e, e);
        }
    }

    /** An object of such a class, by its public constructor without arguments. */
    <T> T make(String parameter, String className, Class<T> type) {
        String asked = parameter + "=" + className;
        try {
            return find(parameter, className, type).getConstructor().newInstance();
        } catch (InvocationTargetException e) {
            throw new UserError(asked + ": cannot be made: " + e.getCause(), e);
        } catch (ReflectiveOperationException e) {
            throw new UserError(asked + ": needs a public constructor without arguments", e);
        }
    }
}
