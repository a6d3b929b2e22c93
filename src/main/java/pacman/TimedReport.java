package pacman;

/**
 * How punctual the controllers of a timed game were.
 *
 * @param pacMan Ms. Pac-Man's controller
 * @param ghosts the ghosts' controller
 */
public record TimedReport(Side pacMan, Side ghosts) {

    /**
     * One side of a timed game.
     *
     * @param steps steps played
     * @param lateAnswers answers that came after the step for which they were wanted
     * @param repeatedMoves steps that were played by the answer stored before, or by none, because there was no new one
     * @param failure the exception that froze the controller on its last answer; null if none did
     */
    public record Side(int steps, int lateAnswers, int repeatedMoves, Throwable failure) {

        /** Decisions that threw: the first one ends a controller's decisions in a game, so this is 0 or 1. */
        public int exceptions() {
            return failure == null ? 0 : 1;
        }
    }
}
