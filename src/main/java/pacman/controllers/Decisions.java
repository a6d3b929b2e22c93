package pacman.controllers;

/**
 * What the workers of a controller did since it was last made ready for a timed game.
 *
 * @param updates states handed over
 * @param answers decisions that ended with an answer
 * @param isUpToDate whether the state handed over last has been answered
 * @param failure the exception that froze the controller; null if none did
 */
public record Decisions(int updates, int answers, boolean isUpToDate, Throwable failure) {

    /** The decisions so far. */
    public static Decisions of(Controller<?> controller) {
        return controller.decisions();
    }
}
