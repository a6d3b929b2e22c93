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
import mmneat.experiment.NearestName;
import mmneat.experiment.UserError;
import pacman.controllers.Controller;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * Finds controllers by class name: first on the class path that the user gives, then among ours. A name without a package
 * is enough where it is unique.
 *
 * <p>Every mistake (no such class, no controller, the wrong kind of moves, no constructor, unreadable file) is a {@link
 * UserError}.
 */
public final class ControllerLoader {

    /** Where a name without a package is looked for among ours. */
    private static final List<String> OUR_PACKAGES =
            List.of("pacman.controllers.examples.", "pacman.entries.pacman.", "pacman.entries.ghosts.");

    /** For suggestions. */
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

    private final EntryPath classPath;

    /** @param classPath jars and class folders of entries; may be empty */
    public ControllerLoader(List<Path> classPath) {
        this.classPath = new EntryPath(classPath);
    }

    /** A controller of Ms. Pac-Man. */
    public ControllerFactory<MOVE> pacMan(String name) {
        Class<?> type = controller(name, OUR_PAC_MEN);
        requireMoves(type, MOVE.class, "moves for Ms. Pac-Man (MOVE)");
        return new ControllerFactory<>(type);
    }

    /** A ghost team. */
    public ControllerFactory<EnumMap<GHOST, MOVE>> ghosts(String name) {
        Class<?> type = controller(name, OUR_GHOSTS);
        requireMoves(type, Map.class, "moves for the ghosts (EnumMap<GHOST, MOVE>)");
        return new ControllerFactory<>(type);
    }

    private Class<?> controller(String name, List<String> ours) {
        Class<?> type;
        try {
            type = find(name, ours);
        } catch (UnsupportedClassVersionError e) {
            throw new UserError(
                    name + " was compiled for a newer Java than this one ("
                            + Runtime.version().feature() + "); compile it with --release "
                            + Runtime.version().feature(),
                    e);
        } catch (LinkageError e) {
            throw new UserError(name + " cannot be loaded: " + e + "; is everything it needs on the class path?", e);
        }
        if (!Controller.class.isAssignableFrom(type)) {
            throw new UserError(type.getName() + " is not a controller; it must extend pacman.controllers.Controller");
        }
        if (Modifier.isAbstract(type.getModifiers())) {
            throw new UserError(type.getName() + " is abstract; name a class that extends it");
        }
        return type;
    }

    private Class<?> find(String name, List<String> ours) {
        List<String> matches = classPath.classesNamed(name);
        if (matches.size() > 1) {
            throw new UserError("'" + name + "' may be " + String.join(" or ", matches) + "; give it with its package");
        }
        return matches.stream()
                .findFirst()
                .map(classPath::load)
                .or(() -> ours(name))
                .orElseThrow(() -> notFound(name, ours));
    }

    private static Optional<Class<?>> ours(String name) {
        List<String> candidates = name.contains(".")
                ? List.of(name)
                : OUR_PACKAGES.stream().map(start -> start + name).toList();
        for (String candidate : candidates) {
            try {
                return Optional.of(Class.forName(candidate, false, ControllerLoader.class.getClassLoader()));
            } catch (ClassNotFoundException e) {
                continue; // The next package may have it; that none has is told by the caller.
            }
        }
        return Optional.empty();
    }

    private UserError notFound(String name, List<String> ours) {
        TreeSet<String> known = new TreeSet<>(ours);
        known.addAll(classPath.controllerNames());
        String suggestion = NearestName.suggestion(name, known);
        if (!classPath.isEmpty()) {
            return new UserError("there is no class '" + name + "' in " + classPath
                    + (suggestion.isEmpty()
                            ? " (controllers there: " + classPath.controllerNames() + ")"
                            : suggestion));
        }
        if (suggestion.isEmpty() && name.contains(".")) {
            return new UserError("there is no class '" + name + "'; give its jar or class folder as classpath=FILE");
        }
        return new UserError("there is no controller '" + name + "'"
                + (suggestion.isEmpty() ? "; known: " + String.join(", ", ours) : suggestion));
    }

    /** Looks at the type of the answers; what a raw class hides is left to the game. */
    private static void requireMoves(Class<?> type, Class<?> moves, String meaning) {
        Class<?> answers = typeOfAnswers(type).or(() -> typeOfDecision(type)).orElse(moves);
        if (!moves.isAssignableFrom(answers)) {
            throw new UserError(
                    type.getName() + " does not decide on " + meaning + "; it answers with " + answers.getSimpleName());
        }
    }

    /** What a class puts in the place of the T of {@code Controller<T>}, through all its superclasses. */
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

    /** What a class without type parameters declares that its decision returns. */
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
