package mmneat.contest;

import java.util.List;
import java.util.Optional;
import pacman.TimedReport;

/**
 * The result of the games of a contest played so far.
 *
 * @param scores scores of the games that count, in the order of the games. Every game without a failure of a controller
 *     counts. Of games with a failure: under {@link OnFailure#SKIP} none counts; under {@link OnFailure#SCORE0} each
 *     counts with a score of 0; under {@link OnFailure#STOP} a timed game counts, because it continues after a failure,
 *     and an untimed game does not
 * @param steps total steps of the games that count
 * @param pacMan punctuality of Ms. Pac-Man's side over all timed games
 * @param ghosts punctuality of the ghosts' side over all timed games
 * @param failures games in which a controller failed
 * @param repetition the game that was played again; empty if none was
 */
public record ContestResult(
        List<Integer> scores,
        long steps,
        Punctuality pacMan,
        Punctuality ghosts,
        List<GameFailure> failures,
        Optional<Repetition> repetition) {

    /**
     * Punctuality of a side over several timed games.
     *
     * @param steps steps played
     * @param lateAnswers answers that came after their step
     * @param exceptions decisions that threw an exception, at most one per game
     * @param repeatedMoves steps that used an earlier answer or none
     */
    public record Punctuality(long steps, long lateAnswers, long exceptions, long repeatedMoves) {
        static final Punctuality NONE = new Punctuality(0, 0, 0, 0);

        Punctuality plus(TimedReport.Side side) {
            return new Punctuality(
                    steps + side.steps(),
                    lateAnswers + side.lateAnswers(),
                    exceptions + side.exceptions(),
                    repeatedMoves + side.repeatedMoves());
        }
    }

    /**
     * A game that was played twice, with new controllers each time.
     *
     * @param game number of the game, from 1
     * @param score its score
     * @param steps its steps
     * @param scoreAgain its score when played again; empty if a controller failed then
     * @param stepsAgain its steps when played again
     */
    public record Repetition(int game, int score, int steps, Optional<Integer> scoreAgain, int stepsAgain) {
        /** Whether both games had the same score and steps. */
        public boolean isSame() {
            return scoreAgain.filter(again -> again == score).isPresent() && stepsAgain == steps;
        }
    }

    public ContestResult {
        scores = List.copyOf(scores);
        failures = List.copyOf(failures);
    }
}
