package pacman.controllers.examples;

import java.util.Optional;
import pacman.controllers.Controller;
import pacman.controllers.ReadOnlyController;

/**
 * The rule that says which controllers may read the live game instead of a copy: the examples that implement
 * {@link ReadOnlyController}.
 *
 * <p>The controller's own class must be an example, loaded with this program: a subclass may do more than read, and so may a
 * class of an entry, whatever it implements and however its package is called.
 */
public final class LiveReaders {

    private LiveReaders() {}

    /** The controller as one that reads the live game; empty if it must be given a copy. */
    @SuppressWarnings("unchecked") // The examples answer getMove and decide with the same type.
    public static <T> Optional<ReadOnlyController<T>> of(Controller<T> controller) {
        // One package object per class loader: an entry's package of the same name is another.
        boolean isExample = controller.getClass().getPackage() == LiveReaders.class.getPackage();
        return isExample && controller instanceof ReadOnlyController<?> reader
                ? Optional.of((ReadOnlyController<T>) reader)
                : Optional.empty();
    }
}
