package mmneat.contest.entry;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import mmneat.experiment.UserError;
import pacman.controllers.Controller;

/**
 * Makes controllers of one class.
 *
 * @param <T> {@code MOVE} for Ms. Pac-Man, {@code EnumMap<GHOST, MOVE>} for the ghosts
 */
public final class ControllerFactory<T> {

    private final Class<?> type;
    private final Constructor<?> constructor;

    /** @param type a concrete subclass of {@link Controller} that decides on the right kind of moves */
    ControllerFactory(Class<?> type) {
        this.type = type;
        try {
            constructor = type.getDeclaredConstructor();
            constructor.setAccessible(true);
        } catch (NoSuchMethodException e) {
            throw new UserError(type.getName() + " has no constructor without arguments; add one", e);
        } catch (LinkageError e) {
            throw unusable(e);
        }
    }

    /** The class's name, without its package if it is one of ours. */
    public String name() {
        return type.getClassLoader() == Controller.class.getClassLoader() ? type.getSimpleName() : type.getName();
    }

    /** A new controller. While it is made, its own classes and files are what libraries find by the thread's class loader. */
    @SuppressWarnings("unchecked") // ControllerLoader has looked at the type of the moves.
    public Controller<T> create() {
        Thread thread = Thread.currentThread();
        ClassLoader before = thread.getContextClassLoader();
        thread.setContextClassLoader(type.getClassLoader());
        try {
            return (Controller<T>) constructor.newInstance();
        } catch (InvocationTargetException e) {
            throw new UserError("the constructor of " + type.getName() + " threw " + e.getCause(), e);
        } catch (InstantiationException | IllegalAccessException e) {
            throw new UserError(type.getName() + " cannot be constructed: " + e, e);
        } catch (ExceptionInInitializerError e) {
            throw new UserError("the static initialiser of " + type.getName() + " threw " + e.getCause(), e);
        } catch (LinkageError e) {
            throw unusable(e);
        } finally {
            thread.setContextClassLoader(before);
        }
    }

    private UserError unusable(LinkageError e) {
        return new UserError(
                type.getName() + " cannot be used: " + e + "; is everything it needs on the class path?", e);
    }
}
