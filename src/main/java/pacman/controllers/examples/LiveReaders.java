package pacman.controllers.examples;

import java.util.Optional;
import pacman.controllers.Controller;
import pacman.controllers.ReadOnlyController;

/**
 * The rule that says which controllers may read the live game instead of a copy: the examples that implement {@link
 * ReadOnlyController}. {@link #of} applies it.
 *
 * <p>The class of the controller must be in this package and must be loaded by the class loader of this program. All
 * other classes are refused and get a copy, because they might change the game: subclasses of examples in other
 * packages, and classes of entries, even if they implement the interface and have the same package name.
 */
public final class LiveReaders {

    private LiveReaders() {}

    /** Returns the controller if it may read the live game; empty if it needs a copy. */
    @SuppressWarnings("unchecked") // The examples answer getMove and decide with the same type.
    public static <T> Optional<ReadOnlyController<T>> of(Controller<T> controller) {
        // Packages are compared by identity: each class loader has its own package objects.
        boolean isExample = controller.getClass().getPackage() == LiveReaders.class.getPackage();
        return isExample && controller instanceof ReadOnlyController<?> reader
                ? Optional.of((ReadOnlyController<T>) reader)
                : Optional.empty();
    }
}
