package pacman;

import java.util.Optional;
import pacman.controllers.Controller;

/**
 * Says which controller threw an exception, and when. It travels as a suppressed exception of the controller's own, which
 * leaves the executor unchanged, as in the original; an exception that keeps no others leaves it as this one's cause.
 */
public final class ControllerFailure extends RuntimeException {

    private final String controllerName;
    private final int totalTime;

    private ControllerFailure(Controller<?> controller, int totalTime, Throwable cause) {
        super(controller.getClass().getName() + " threw this at game time " + totalTime, cause, false, false);
        controllerName = controller.getClass().getName();
        this.totalTime = totalTime;
    }

    /** Adds a report to what a controller threw; throws one that has it as its cause if it cannot be added. */
    static void report(Throwable failure, Controller<?> controller, int totalTime) {
        int before = failure.getSuppressed().length;
        failure.addSuppressed(new ControllerFailure(controller, totalTime, null));
        if (failure.getSuppressed().length == before) {
            throw new ControllerFailure(controller, totalTime, failure);
        }
    }

    /**
     * The report that an exception out of a game carries; empty if it did not come from a controller. An exception that was thrown
     * several times carries several reports, the last of which counts.
     */
    public static Optional<ControllerFailure> in(Throwable failure) {
        ControllerFailure last = failure instanceof ControllerFailure report ? report : null;
        for (Throwable suppressed : failure.getSuppressed()) {
            last = suppressed instanceof ControllerFailure report ? report : last;
        }
        return Optional.ofNullable(last);
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
