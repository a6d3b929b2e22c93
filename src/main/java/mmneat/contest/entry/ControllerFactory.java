package mmneat.contest.entry;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import mmneat.contest.entry.ArgumentValues.Argument;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;
import mmneat.neat.Thrown;
import pacman.controllers.Controller;

/**
 * A factory of controllers of one class, which uses the constructor that fits the given arguments. A {@link
 * ControllerLoader} makes the factory; {@link #create} makes a controller, a new one for each game.
 *
 * @param <T> {@code MOVE} for Ms. Pac-Man, {@code EnumMap<GHOST, MOVE>} for the ghosts
 */
public final class ControllerFactory<T> {

    /** A constructor and the values of its parameters. */
    private record Choice(Constructor<?> constructor, List<Argument> values) {
        int rank() {
            return values.stream().mapToInt(Argument::rank).sum();
        }
    }

    private final Class<?> type;
    private final ControllerCall call;
    private final String origin;
    private final Choice choice;

    /**
     * @param type a concrete subclass of {@link Controller} with the right type of moves
     * @param origin the jar or folder that the class comes from; empty if it is one of ours
     */
    ControllerFactory(Class<?> type, ControllerCall call, String origin, ArgumentValues values) {
        this.type = type;
        this.call = call;
        this.origin = origin;
        try {
            choice = choose(values);
            choice.constructor().setAccessible(true);
        } catch (LinkageError e) {
            throw unusable(e);
        }
    }

    private Choice choose(ArgumentValues values) {
        // Ties are broken alphabetically, because the order of reflection is undefined.
        return Arrays.stream(type.getDeclaredConstructors())
                .sorted(Comparator.comparing(Constructor::toGenericString))
                .map(constructor -> fitting(constructor, values))
                .flatMap(Optional::stream)
                .min(Comparator.comparingInt(Choice::rank))
                .orElseThrow(this::noConstructor);
    }

    private Optional<Choice> fitting(Constructor<?> constructor, ArgumentValues values) {
        Class<?>[] parameters = constructor.getParameterTypes();
        if (parameters.length != call.arguments().size()) {
            return Optional.empty();
        }
        List<Argument> arguments = new ArrayList<>();
        for (int i = 0; i < parameters.length; i++) {
            Optional<Argument> argument = values.of(call.arguments().get(i), parameters[i]);
            if (argument.isEmpty()) {
                return Optional.empty();
            }
            arguments.add(argument.get());
        }
        return Optional.of(new Choice(constructor, arguments));
    }

    private UserError noConstructor() {
        String existing = Arrays.stream(type.getDeclaredConstructors())
                .map(constructor -> Arrays.stream(constructor.getParameterTypes())
                        .map(Class::getSimpleName)
                        .collect(Collectors.joining(", ", type.getSimpleName() + "(", ")")))
                .sorted()
                .collect(Collectors.joining(" and "));
        String wanted =
                call.arguments().isEmpty() ? "without arguments" : "for (" + String.join(", ", call.arguments()) + ")";
        return new UserError(type.getName() + " has no constructor " + wanted + "; it has " + existing
                + ": give numbers, true or false, texts or controllers, as in '" + type.getSimpleName()
                + "(Legacy,3)', in quotes for the shell");
    }

    /** The class's name, without its package if it is one of ours, and the arguments if there are any. */
    public String name() {
        String name =
                type.getClassLoader() == Controller.class.getClassLoader() ? type.getSimpleName() : type.getName();
        return call.arguments().isEmpty() ? name : name + "(" + String.join(",", call.arguments()) + ")";
    }

    /** The jar or folder that the class comes from; empty if it comes with this program. */
    public String origin() {
        return origin;
    }

    /**
     * Creates a controller. During creation the thread's class loader is that of the entry, so that libraries find its
     * classes and files.
     */
    @SuppressWarnings("unchecked") // ControllerLoader has looked at the type of the moves.
    public Controller<T> create() {
        return (Controller<T>) createObject();
    }

    Object createObject() {
        Thread thread = Thread.currentThread();
        ClassLoader before = thread.getContextClassLoader();
        thread.setContextClassLoader(type.getClassLoader());
        try {
            return choice.constructor()
                    .newInstance(choice.values().stream()
                            .map(argument -> argument.value().get())
                            .toArray());
        } catch (InvocationTargetException e) {
            throw new UserError(
                    "the constructor of " + type.getName() + " threw " + PlainText.shown(e.getCause())
                            + MissingMember.explanation(e.getCause()),
                    e);
        } catch (InstantiationException | IllegalAccessException e) {
            throw new UserError(type.getName() + " cannot be constructed: " + PlainText.shown(e), e);
        } catch (ExceptionInInitializerError e) {
            throw new UserError(
                    "the static initialiser of " + type.getName() + " threw " + PlainText.shown(e.getCause()), e);
        } catch (LinkageError e) {
            throw unusable(e);
        } catch (UserError e) {
            throw e;
        } catch (Throwable e) {
            new Thrown(e).passOnIfOfTheMachine();
            // An Error that a static initialiser throws arrives unwrapped.
            throw new UserError("the static initialiser of " + type.getName() + " threw " + PlainText.shown(e), e);
        } finally {
            thread.setContextClassLoader(before);
        }
    }

    private UserError unusable(LinkageError e) {
        return new UserError(type.getName() + " cannot be used: " + PlainText.shown(e) + missing(e), e);
    }

    /** Returns advice about a class or member that an entry needs and that is missing. */
    static String missing(LinkageError e) {
        String explanation = MissingMember.explanation(e);
        return explanation.isEmpty() ? "; is everything it needs on the class path?" : explanation;
    }
}
