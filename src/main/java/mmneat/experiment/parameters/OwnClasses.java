package mmneat.experiment.parameters;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Modifier;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import mmneat.experiment.ClassPlace;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;
import mmneat.neat.Thrown;
import org.jspecify.annotations.Nullable;

/**
 * Loader of the user's classes that parameters name, from the class path or from {@code jar=FILE}. {@link NamedCode}
 * checks before whether they may be loaded.
 */
final class OwnClasses {

    private static final Pattern NAME = Pattern.compile("\\p{javaJavaIdentifierStart}\\p{javaJavaIdentifierPart}*"
            + "(\\.\\p{javaJavaIdentifierStart}\\p{javaJavaIdentifierPart}*)*");

    private final String jar;

    /** Created with the first request for a class; parameters may name a jar that is not needed. */
    private @Nullable ClassLoader loader;

    /**
     * Opens the jar or folder, if there is one.
     *
     * @param jar a jar or a folder of classes, searched after the class path; empty: the class path only
     */
    OwnClasses(String jar) {
        this.jar = jar;
    }

    private synchronized ClassLoader loader() {
        if (loader == null) {
            ClassLoader ours = OwnClasses.class.getClassLoader();
            // It stays open while the program runs, because a class may load others at any time.
            loader = jar.isEmpty() ? ours : new URLClassLoader(new URL[] {url(jar)}, ours);
        }
        return loader;
    }

    /** Whether a text can be the full name of a class. */
    static boolean isName(String text) {
        return NAME.matcher(text).matches();
    }

    /**
     * The names in a list that is separated by commas; none if it is blank.
     *
     * @param parameter the parameter with this list, for messages
     * @throws UserError if a name in it is empty
     */
    static List<String> names(String parameter, String list) {
        if (list.isBlank()) {
            return List.of();
        }
        List<String> names = Stream.of(list.split(",", -1)).map(String::strip).toList();
        if (names.contains("")) {
            throw new UserError(parameter + "=" + list + ": a name is missing; separate the names by single commas");
        }
        return names;
    }

    /** Whether there is a class with a name. Nothing in it runs. */
    boolean has(String className) {
        try {
            Class.forName(className, false, loader());
            return true;
        } catch (ClassNotFoundException | LinkageError e) {
            return false;
        }
    }

    private static URL url(String jar) {
        Path file = Path.of(jar);
        if (!Files.isReadable(file)) {
            throw new UserError("jar=" + jar + ": the file is missing or not readable");
        }
        ClassPlace.require("jar=" + jar, file);
        try {
            return file.toUri().toURL();
        } catch (MalformedURLException e) {
            throw new UserError("jar=" + jar + ": is not a valid file name", e);
        }
    }

    /**
     * Finds a class by its name.
     *
     * @param parameter the parameter that names it, for messages
     * @param type the required type
     * @throws UserError if there is no such class, or its jar cannot be read
     */
    <T> Class<? extends T> find(String parameter, String className, Class<T> type) {
        String asked = parameter + "=" + className;
        try {
            // The class is not initialised before its type has been checked.
            return Class.forName(className, false, loader()).asSubclass(type);
        } catch (ClassNotFoundException e) {
            throw new UserError(
                    asked + ": there is no such class"
                            + (jar.isEmpty()
                                    ? "; name its jar with jar=FILE"
                                    : " in " + jar + ClassPlace.sourceHint(Path.of(jar), className)),
                    e);
        } catch (ClassCastException e) {
            throw new UserError(
                    asked + ": the class must " + (type.isInterface() ? "implement " : "extend ") + type.getName(), e);
        } catch (LinkageError e) {
            throw new UserError(asked + ": the class cannot be loaded: " + PlainText.shown(e), e);
        }
    }

    /**
     * Asks an object of the user's own for something that must not be null.
     *
     * @param asked the parameter, the class and the method, for messages
     * @throws UserError if the method throws or returns null
     */
    static <T> T ask(String asked, Supplier<T> method) {
        T answer;
        try {
            answer = method.get();
        } catch (Throwable e) {
            new Thrown(e).passOnIfOfTheMachine();
            throw new UserError(asked + " threw " + PlainText.shown(e), e);
        }
        if (answer == null) {
            throw new UserError(asked + " must not be null");
        }
        return answer;
    }

    /** @param asked the parameter and the class, for the message */
    static void requirePublic(String asked, Class<?> type) {
        if (!Modifier.isPublic(type.getModifiers())) {
            throw new UserError(asked + ": the class must be public");
        }
    }

    /** Creates an object of such a class by its public constructor without arguments. */
    <T> T make(String parameter, String className, Class<T> type) {
        String asked = parameter + "=" + className;
        Class<? extends T> found = find(parameter, className, type);
        requirePublic(asked, found);
        return created(asked, "without arguments", () -> found.getConstructor().newInstance());
    }

    /** The call of a constructor by reflection. */
    interface Construction<T> {
        T make() throws ReflectiveOperationException;
    }

    /**
     * Creates an object of a class of the user's own.
     *
     * @param asked the parameter and the class, for messages
     * @param arguments the arguments that the constructor must have, for messages
     * @throws UserError if there is no such constructor, or it or a static initialiser throws
     */
    static <T> T created(String asked, String arguments, Construction<T> construction) {
        try {
            return construction.make();
        } catch (InvocationTargetException | ExceptionInInitializerError e) {
            throw notCreated(asked, Objects.requireNonNullElse(e.getCause(), e));
        } catch (InstantiationException e) {
            throw new UserError(asked + ": the class must not be abstract", e);
        } catch (ReflectiveOperationException e) {
            throw new UserError(asked + ": needs a public constructor " + arguments, e);
        } catch (Error e) {
            // An Error that a static initialiser throws arrives unwrapped.
            new Thrown(e).passOnIfOfTheMachine();
            throw notCreated(asked, e);
        }
    }

    private static UserError notCreated(String asked, Throwable thrown) {
        return new UserError(asked + ": cannot be created: " + PlainText.shown(thrown), thrown);
    }
}
