package pacman;

import org.jspecify.annotations.Nullable;

/**
 * The punctuality of the controllers of a timed game.
 *
 * @param pacMan Ms. Pac-Man's controller
 * @param ghosts the ghosts' controller
 */
public record TimedReport(Side pacMan, Side ghosts) {

    /**
     * One side of a timed game.
     *
     * @param steps steps played
     * @param lateAnswers answers that came after their step
     * @param repeatedMoves steps played with an earlier answer or none, because there was no new one
     * @param failure the exception that froze the controller on its last answer; null if none did
     */
    public record Side(
            int steps,
            int lateAnswers,
            int repeatedMoves,
            @Nullable Throwable failure) {

        /**
         * Number of decisions that threw an exception: 0 or 1, because the first one ends a controller's decisions in a
         * game.
         */
        public int exceptions() {
            return failure == null ? 0 : 1;
        }
    }
}
