package mmneat.contest;

import java.io.PrintWriter;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import mmneat.contest.ContestResult.Repetition;
import mmneat.contest.GamePlay.Outcome;
import mmneat.experiment.ExitGuard;
import mmneat.experiment.PlainText;
import mmneat.neat.Thrown;
import pacman.GameSeries;
import pacman.game.Game;

/**
 * A contest between two controllers: plays its games one after the other. The same settings give the same games, unless
 * a controller uses its own random generator or the clock.
 */
public final class Contest {

    /** The exit code if a controller ends the program. */
    private static final int ENDED = 2;

    private static final int PROGRESS_SECONDS = 5;
    private static final long STALL_MILLISECONDS = 10_000;

    /** Maximum number of printed lines of a stack trace; endless recursion produces a thousand. */
    private static final int TRACE_LINES = 25;

    private static final Pattern OUR_FRAME = Pattern.compile(
            "^\\tat (app//)?(mmneat|picocli|pacman\\.(UntimedRun|Executor))\\b|Suppressed: pacman\\.ControllerFailure");

    private final ContestSettings settings;
    private final PrintWriter notes;
    private final ContestTally tally = new ContestTally();
    private long nextProgress;

    /** @param notes receives progress and the failures of controllers */
    public Contest(ContestSettings settings, PrintWriter notes) {
        this.settings = settings;
        this.notes = notes;
    }

    /**
     * Plays all games.
     *
     * @param afterStep called with the game after each step, for example to record it
     * @param ended called with the result so far, in a shutdown hook, if the program is ended during the games
     * @return the result; it has fewer games than requested if a failure stopped the contest
     */
    public ContestResult play(Consumer<Game> afterStep, Consumer<ContestResult> ended) {
        AtomicInteger playing = new AtomicInteger(1);
        ExitGuard guard = new ExitGuard(ENDED, caller -> reportEnd(caller, playing.get(), ended));
        try (StallNotice stall = new StallNotice(notes, STALL_MILLISECONDS)) {
            playAll(new GamePlay(settings, stall), afterStep, playing);
        } finally {
            guard.remove();
        }
        return tally.result();
    }

    private void playAll(GamePlay play, Consumer<Game> afterStep, AtomicInteger playing) {
        GameSeries series = new GameSeries(settings.rules(), settings.seed());
        nextProgress = System.nanoTime() + TimeUnit.SECONDS.toNanos(PROGRESS_SECONDS);
        Repetition first = null;
        for (int number = 1; number <= settings.games(); number++) {
            playing.set(number);
            Outcome outcome = play.play(series.next(), number, afterStep);
            note(outcome);
            if (outcome.failure().isPresent() && settings.onFailure() == OnFailure.STOP) {
                return;
            }
            if (first == null && outcome.failure().isEmpty()) {
                first = new Repetition(number, outcome.score(), outcome.steps(), Optional.empty(), 0);
            }
            tellProgress(number);
        }
        if (settings.isRepeated() && first != null) {
            tally.setRepetition(repeat(play, first));
        }
    }

    private void note(Outcome outcome) {
        outcome.timed().ifPresent(tally::addTimed);
        outcome.failure().ifPresent(this::noteFailure);
        boolean failed = outcome.failure().isPresent();
        // A timed game continues when a controller fails, so the contest stops after the game.
        if (!failed || settings.onFailure() == OnFailure.STOP && outcome.isFinished()) {
            tally.addGame(outcome.score(), outcome.steps());
        } else if (settings.onFailure() == OnFailure.SCORE0) {
            tally.addGame(0, outcome.steps());
        }
    }

    private void noteFailure(GameFailure failure) {
        tally.addFailure(failure);
        if (failure.thrown().isEmpty() && settings.onFailure() == OnFailure.STOP) {
            // The message at the end of the contest contains the whole stack trace.
            return;
        }
        String what =
                failure.thrown().isPresent() ? failure.controller() + " threw an exception" : failure.sentence() + ",";
        notes.println("mmneat: " + what + " " + failure.place());
        if (settings.timing() == Timing.NONE) {
            // In a timed game Java has already printed it in the controller's thread.
            failure.thrown().map(Contest::trace).ifPresent(notes::println);
        }
        notes.flush();
    }

    /** Returns the stack trace without this program's frames that lead to the controller. */
    private static String trace(Throwable thrown) {
        return new Thrown(thrown)
                .trace()
                .lines()
                .filter(line -> !OUR_FRAME.matcher(line).find())
                .limit(TRACE_LINES)
                .map(PlainText::shown)
                .collect(Collectors.joining(System.lineSeparator()));
    }

    private void tellProgress(int number) {
        if (number == settings.games() || System.nanoTime() < nextProgress) {
            return;
        }
        nextProgress += TimeUnit.SECONDS.toNanos(PROGRESS_SECONDS);
        notes.println(String.format(
                Locale.ROOT, "%d of %d games, mean score %.1f", number, settings.games(), tally.meanScore()));
        notes.flush();
    }

    private Repetition repeat(GamePlay play, Repetition first) {
        GameSeries series = new GameSeries(settings.rules(), settings.seed());
        Game game = series.next();
        for (int number = 1; number < first.game(); number++) {
            game = series.next();
        }
        Outcome again = play.play(game, first.game(), state -> {});
        Optional<Integer> score = again.failure().isEmpty() ? Optional.of(again.score()) : Optional.empty();
        return new Repetition(first.game(), first.score(), first.steps(), score, again.steps());
    }

    /** The calls of exit that the byte code of an entry shows are failures of it; others end the contest. */
    private void reportEnd(Optional<String> caller, int playing, Consumer<ContestResult> ended) {
        ContestResult result = tally.result();
        ended.accept(result);
        notes.println("mmneat: " + caller.map(ExitGuard::sentence).orElse("the program was ended") + " in game "
                + playing + " of " + settings.games() + "; "
                + (result.scores().isEmpty() ? "there is no result" : "the result is that of the games before"));
        notes.flush();
    }
}
