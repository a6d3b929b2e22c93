package pacman;

import java.util.Optional;
import pacman.controllers.Controller;

/**
 * Says which controller threw an exception, and when. It travels as a suppressed exception of the controller's own, which
 * leaves the executor unchanged, as in the original.
 */
public final class ControllerFailure extends RuntimeException {

    private final String controllerName;
    private final int totalTime;

    ControllerFailure(Controller<?> controller, int totalTime) {
        super(controller.getClass().getName() + " threw this at game time " + totalTime, null, false, false);
        controllerName = controller.getClass().getName();
        this.totalTime = totalTime;
    }

    /** The report that an exception out of a game carries; empty if it did not come from a controller. */
    public static Optional<ControllerFailure> in(Throwable failure) {
        for (Throwable suppressed : failure.getSuppressed()) {
            if (suppressed instanceof ControllerFailure report) {
                return Optional.of(report);
            }
        }
        return Optional.empty();
    }

    /** Class name of the controller that threw. */
    public String controllerName() {
        return controllerName;
    }

    /** Total time of the game in which it was asked, in game steps. */
    public int totalTime() {
        return totalTime;
    }
}
