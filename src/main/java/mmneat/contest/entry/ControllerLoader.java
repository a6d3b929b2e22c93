package mmneat.contest.entry;

import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.Supplier;
import mmneat.experiment.NearestName;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;
import pacman.controllers.Controller;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * Finder of controllers by class name, first on the user's class path, then in this program. The package can be left
 * out if the name is unique.
 *
 * <p>This program has two skeletons, {@code MyPacMan} and {@code MyGhosts} in {@code pacman.entries}, whose names are
 * also those of most entries. If a class path is given, the skeletons are not found: if the user's {@code MyPacMan} is
 * missing there, that is an error, and the skeleton does not play in its place.
 *
 * <p>Every error (no such class, not a controller, the wrong type of moves, no constructor, unreadable file) is a
 * {@link UserError}.
 */
public final class ControllerLoader {

    /** The packages of this program that are searched for a name without a package. */
    private static final List<String> OUR_PACKAGES =
            List.of("pacman.controllers.examples.", "pacman.entries.pacman.", "pacman.entries.ghosts.");

    /** The names of our controllers, for suggestions. */
    private static final List<String> OUR_PAC_MEN = List.of(
            "MyPacMan",
            "NearestPillPacMan",
            "NearestPillPacManVS",
            "RandomNonRevPacMan",
            "RandomPacMan",
            "StarterPacMan");

    private static final List<String> OUR_GHOSTS = List.of(
            "AggressiveGhosts",
            "BetterLegacy",
            "ChaseFleeGhosts",
            "DeterministicLegacy",
            "Legacy",
            "Legacy2TheReckoning",
            "MyGhosts",
            "PansyGhosts",
            "RandomGhosts",
            "StarterGhosts",
            "VeryRandomLegacy");

    private final String option;
    private final EntryPath classPath;

    /** @param classPath jars and class folders of entries; may be empty */
    public ControllerLoader(List<Path> classPath) {
        this("classpath", classPath);
    }

    /**
     * @param option name of the option that gives the class path, for messages
     * @param classPath jars and class folders of entries, the first of which is searched first; may be empty
     */
    public ControllerLoader(String option, List<Path> classPath) {
        this.option = option;
        this.classPath = new EntryPath(option, classPath);
    }

    /**
     * Returns a factory of controllers of Ms.&nbsp;Pac-Man.
     *
     * @param call name of a class, and the arguments of its constructor, as in {@code my.Entry(Legacy,3)}
     */
    public ControllerFactory<MOVE> pacMan(String call) {
        return controller(ControllerCall.parse(call), OUR_PAC_MEN, MOVE.class, "moves for Ms. Pac-Man (MOVE)");
    }

    /**
     * Returns a factory of ghost controllers.
     *
     * @param call name of a class, and the arguments of its constructor
     */
    public ControllerFactory<EnumMap<GHOST, MOVE>> ghosts(String call) {
        return controller(
                ControllerCall.parse(call), OUR_GHOSTS, Map.class, "moves for the ghosts (EnumMap<GHOST, MOVE>)");
    }

    private <T> ControllerFactory<T> controller(
            ControllerCall call, List<String> ours, Class<?> moves, String meaning) {
        Class<?> type = type(call.name(), ours);
        if (!Controller.class.isAssignableFrom(type)) {
            throw new UserError(type.getName() + " is not a controller; it must extend pacman.controllers.Controller");
        }
        if (Modifier.isAbstract(type.getModifiers())) {
            throw new UserError(type.getName() + " is abstract; name a class that extends it");
        }
        requireMoves(type, moves, meaning);
        return factory(type, call);
    }

    private <T> ControllerFactory<T> factory(Class<?> type, ControllerCall call) {
        boolean isEntry = type.getClassLoader() instanceof EntryClassLoader;
        return new ControllerFactory<>(
                type,
                call,
                isEntry ? classPath.placeOf(type.getName()) : "",
                new ArgumentValues((argument, wanted) -> argument(argument, wanted, type)));
    }

    /** Finds a controller that is a constructor argument of another: a class of the same entry, or one of ours. */
    private Optional<Supplier<?>> argument(String text, Class<?> wanted, Class<?> owner) {
        ControllerCall call = ControllerCall.read(text).orElse(null);
        if (call == null) {
            return Optional.empty();
        }
        List<String> matches =
                owner.getClassLoader() instanceof EntryClassLoader ? classPath.classesNamed(call.name()) : List.of();
        Optional<Class<?>> type = matches.size() == 1
                ? Optional.of(((EntryClassLoader) owner.getClassLoader()).load(matches.get(0)))
                : ours(call.name());
        return type.filter(wanted::isAssignableFrom)
                .filter(found -> !Modifier.isAbstract(found.getModifiers()))
                .map(found -> factory(found, call)::createObject);
    }

    private Class<?> type(String name, List<String> ours) {
        try {
            return find(name, ours);
        } catch (UnsupportedClassVersionError e) {
            throw new UserError(
                    name + " was compiled for a newer Java than this one ("
                            + Runtime.version().feature() + "); compile it with --release "
                            + Runtime.version().feature(),
                    e);
        } catch (LinkageError e) {
            throw new UserError(name + " cannot be loaded: " + PlainText.shown(e) + ControllerFactory.missing(e), e);
        }
    }

    private Class<?> find(String name, List<String> ours) {
        List<String> matches = classPath.classesNamed(name);
        if (matches.size() > 1) {
            throw new UserError("'" + name + "' may be " + String.join(" or ", matches) + "; give it with its package");
        }
        return matches.stream()
                .findFirst()
                .map(classPath::load)
                .or(() -> ours(name).filter(this::mayStandIn))
                .orElseThrow(() -> notFound(name, ours));
    }

    /**
     * Whether our class may be used. Our skeletons have the names of entries, so they are not used if there is a class
     * path.
     */
    private boolean mayStandIn(Class<?> ours) {
        return classPath.isEmpty() || !EntryClassLoader.isSkeleton(ours.getName());
    }

    private static Optional<Class<?>> ours(String name) {
        List<String> candidates = name.contains(".")
                ? List.of(name)
                : OUR_PACKAGES.stream().map(start -> start + name).toList();
        for (String candidate : candidates) {
            try {
                return Optional.of(Class.forName(candidate, false, ControllerLoader.class.getClassLoader()));
            } catch (ClassNotFoundException e) {
                continue; // The next package may have it. The caller reports if no package has it.
            }
        }
        return Optional.empty();
    }

    private UserError notFound(String name, List<String> ours) {
        TreeSet<String> known = new TreeSet<>(ours);
        known.addAll(classPath.controllerNames());
        String suggestion = NearestName.suggestion(name, known);
        if (!classPath.isEmpty()) {
            String source = classPath.sourceHint(name);
            if (!source.isEmpty()) {
                return new UserError("there is no class '" + name + "' in " + classPath + source);
            }
            return new UserError("there is no class '" + name + "' in " + classPath
                    + (suggestion.isEmpty()
                            ? " (controllers there: " + classPath.controllerNames() + ")"
                            : suggestion));
        }
        if (suggestion.isEmpty() && name.contains(".")) {
            return new UserError(
                    "there is no class '" + name + "'; give its jar or class folder as " + option + "=FILE");
        }
        return new UserError("there is no controller '" + name + "'"
                + (suggestion.isEmpty() ? "; known: " + String.join(", ", ours) : suggestion));
    }

    /** Checks the type of the answers. The type of a raw class is unknown here; the game checks its answers. */
    private static void requireMoves(Class<?> type, Class<?> moves, String meaning) {
        Class<?> answers = typeOfAnswers(type).or(() -> typeOfDecision(type)).orElse(moves);
        if (!moves.isAssignableFrom(answers)) {
            throw new UserError(type.getName() + " must return " + meaning + ", returns " + answers.getSimpleName());
        }
    }

    /** Returns the type argument for T of {@code Controller<T>}, resolved through all superclasses. */
    private static Optional<Class<?>> typeOfAnswers(Class<?> type) {
        Map<Type, Type> known = new HashMap<>();
        for (Class<?> heir = type; heir != Controller.class; heir = heir.getSuperclass()) {
            if (heir.getGenericSuperclass() instanceof ParameterizedType parent) {
                Type[] names = heir.getSuperclass().getTypeParameters();
                for (int i = 0; i < names.length; i++) {
                    Type given = parent.getActualTypeArguments()[i];
                    known.put(names[i], known.getOrDefault(given, given));
                }
            }
        }
        Type answers = known.get(Controller.class.getTypeParameters()[0]);
        Type plain = answers instanceof ParameterizedType parameterized ? parameterized.getRawType() : answers;
        return plain instanceof Class<?> found ? Optional.of(found) : Optional.empty();
    }

    /** Returns the declared return type of the decision method of a raw class. */
    private static Optional<Class<?>> typeOfDecision(Class<?> type) {
        for (Class<?> declaring = type; declaring != Controller.class; declaring = declaring.getSuperclass()) {
            for (Method method : declaring.getDeclaredMethods()) {
                Class<?> answers = method.getReturnType();
                boolean decides = method.getName().equals("getMove")
                        && !method.isBridge()
                        && List.of(method.getParameterTypes()).equals(List.of(Game.class, long.class));
                if (decides && (answers == MOVE.class || Map.class.isAssignableFrom(answers))) {
                    return Optional.of(answers);
                }
            }
        }
        return Optional.empty();
    }
}
