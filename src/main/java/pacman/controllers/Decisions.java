package pacman.controllers;

import org.jspecify.annotations.Nullable;

/**
 * Counts of a controller's decisions since it was last made ready for a timed game.
 *
 * @param updates states passed to the controller
 * @param answers decisions that ended with an answer
 * @param isUpToDate whether the last state passed has been answered
 * @param failure the exception that froze the controller; null if none did
 */
public record Decisions(
        int updates,
        int answers,
        boolean isUpToDate,
        @Nullable Throwable failure) {

    /** Returns the counts so far. */
    public static Decisions of(Controller<?> controller) {
        return controller.decisions();
    }
}
