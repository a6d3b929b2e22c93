package pacman;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import pacman.controllers.Controller;

/**
 * A record of which controller threw an exception, and when. It is attached to the controller's exception as a
 * suppressed exception, so that the executor throws the controller's exception itself, as in the competition's
 * framework. If an exception does not allow suppressed ones, a ControllerFailure with it as cause is thrown instead.
 */
public final class ControllerFailure extends RuntimeException {

    private final String controllerName;
    private final int totalTime;

    private ControllerFailure(Controller<?> controller, int totalTime, @Nullable Throwable cause) {
        super(controller.getClass().getName() + " threw this at game time " + totalTime, cause, false, false);
        controllerName = controller.getClass().getName();
        this.totalTime = totalTime;
    }

    /**
     * Adds a report to the exception of a controller; if it cannot be added, throws a report with the exception as
     * cause.
     */
    static void report(Throwable failure, Controller<?> controller, int totalTime) {
        int before = failure.getSuppressed().length;
        failure.addSuppressed(new ControllerFailure(controller, totalTime, null));
        if (failure.getSuppressed().length == before) {
            throw new ControllerFailure(controller, totalTime, failure);
        }
    }

    /**
     * Returns the report attached to an exception from a game; empty if no controller threw it. An exception that was
     * thrown several times has several reports; the last one is returned.
     */
    public static Optional<ControllerFailure> in(Throwable failure) {
        ControllerFailure last = failure instanceof ControllerFailure report ? report : null;
        for (Throwable suppressed : failure.getSuppressed()) {
            last = suppressed instanceof ControllerFailure report ? report : last;
        }
        return Optional.ofNullable(last);
    }

    /** Class name of the controller that threw the exception. */
    public String controllerName() {
        return controllerName;
    }

    /** Total time of the game when the controller was called, in game steps. */
    public int totalTime() {
        return totalTime;
    }
}
