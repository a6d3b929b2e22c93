package mmneat.contest;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import mmneat.contest.ContestResult.Punctuality;
import mmneat.contest.ContestResult.Repetition;
import org.jspecify.annotations.Nullable;
import pacman.TimedReport;

/** The growing result of a contest. Thread-safe: the playing thread writes it, and a shutdown hook may read it. */
final class ContestTally {

    private final List<Integer> scores = new ArrayList<>();
    private final List<GameFailure> failures = new ArrayList<>();
    private long steps;
    private Punctuality pacMan = Punctuality.NONE;
    private Punctuality ghosts = Punctuality.NONE;
    private @Nullable Repetition repetition;

    /** Adds a game that counts. */
    synchronized void addGame(int score, int gameSteps) {
        scores.add(score);
        steps += gameSteps;
    }

    synchronized void addTimed(TimedReport report) {
        pacMan = pacMan.plus(report.pacMan());
        ghosts = ghosts.plus(report.ghosts());
    }

    synchronized void addFailure(GameFailure failure) {
        failures.add(failure);
    }

    synchronized void setRepetition(Repetition played) {
        repetition = played;
    }

    synchronized double meanScore() {
        return scores.stream().mapToInt(Integer::intValue).average().orElse(Double.NaN);
    }

    /** Returns the result so far. */
    synchronized ContestResult result() {
        return new ContestResult(scores, steps, pacMan, ghosts, failures, Optional.ofNullable(repetition));
    }
}
