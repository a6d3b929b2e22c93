package mmneat.contest;

import java.lang.reflect.UndeclaredThrowableException;
import java.time.Duration;
import java.util.EnumMap;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import mmneat.contest.entry.MissingMember;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;
import org.jspecify.annotations.Nullable;
import pacman.ControllerFailure;
import pacman.Executor;
import pacman.TimedReport;
import pacman.controllers.Controller;
import pacman.game.Constants;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/** Plays single games of a contest, each with new controllers, and returns their outcomes. */
final class GamePlay {

    private static final int LAST_LOOK_MILLISECONDS = 2000;
    private static final int LONGEST_LOOK_MILLISECONDS = 100;

    /**
     * The outcome of a game.
     *
     * @param score the score; undefined if {@code isFinished} is false
     * @param steps game steps played
     * @param isFinished whether the game was played to its end
     * @param failure the failure of a controller; a timed game continues after a failure
     * @param timed punctuality of the controllers; empty if the game was not timed or not finished
     */
    record Outcome(
            int score, int steps, boolean isFinished, Optional<GameFailure> failure, Optional<TimedReport> timed) {}

    /**
     * Size of a reserve, in bytes, that is freed when a controller has used all memory, so that the failure can be
     * reported.
     */
    private static final int RESERVE = 4 << 20;

    private final ContestSettings settings;
    private final StallNotice stall;
    private byte @Nullable [] reserve = new byte[RESERVE];
    private final Executor executor = new Executor();

    GamePlay(ContestSettings settings, StallNotice stall) {
        this.settings = settings;
        this.stall = stall;
    }

    /**
     * Plays a game.
     *
     * @param number number of the game, from 1
     * @param afterStep called with the game after each step
     */
    Outcome play(Game game, int number, Consumer<Game> afterStep) {
        boolean isLimited = settings.moveLimit() != null && settings.timing() == Timing.NONE;
        stall.watch(isLimited || settings.timing() != Timing.NONE ? null : game);
        try {
            Optional<TimedReport> report = isLimited ? playLimited(game, afterStep) : playToTheEnd(game, afterStep);
            return finished(game, number, report);
        } catch (NoAnswer late) {
            String what = "did not answer for " + moveLimit().toSeconds() + " s";
            return failed(game, number, late.controller, what, null);
        } catch (OutOfMemoryError failure) {
            reserve = null;
            return failed(game, number, failure);
        } catch (Throwable failure) {
            // An entry may throw anything, also checked exceptions that no method declares.
            return failed(game, number, failure);
        } finally {
            stall.watch(null);
        }
    }

    private Optional<TimedReport> playToTheEnd(Game game, Consumer<Game> afterStep) {
        Controller<MOVE> player = settings.pacMan().controllers().get();
        Controller<EnumMap<GHOST, MOVE>> team = settings.ghosts().controllers().get();
        Optional<TimedReport> report = Optional.empty();
        if (settings.timing() != Timing.NONE) {
            Executor.Pace pace =
                    settings.timing() == Timing.REAL_TIME ? Executor.Pace.REAL_TIME : Executor.Pace.UNTIL_ANSWERED;
            report = Optional.of(executor.runGameTimed(player, team, game, pace, settings.isShown(), afterStep));
        } else if (settings.isShown()) {
            executor.runGame(player, team, game, true, Constants.DELAY, afterStep);
        } else {
            executor.runExperiment(player, team, game, afterStep);
        }
        if (settings.isShown()) {
            pause(LAST_LOOK_MILLISECONDS);
        }
        return report;
    }

    /** Thrown when a controller did not answer in time. */
    private static final class NoAnswer extends RuntimeException {
        private static final long serialVersionUID = 1;
        private final String controller;

        NoAnswer(String controller) {
            super(controller, null, false, false);
            this.controller = controller;
        }
    }

    /**
     * The end of a game that another thread plays.
     *
     * @param report of a timed game
     * @param failure what ended the game early. It is not the future's exception, because the future would call its
     *     methods, which may fail
     */
    private record End(
            Optional<TimedReport> report, @Nullable Throwable failure) {}

    /*
     * A separate thread plays the game, because Java cannot stop a thread that does not cooperate. A controller that
     * never answers is interrupted, and its thread is abandoned.
     */
    private Optional<TimedReport> playLimited(Game game, Consumer<Game> afterStep) throws Throwable {
        CompletableFuture<End> end = new CompletableFuture<>();
        Thread player = new Thread(
                () -> {
                    try {
                        end.complete(new End(playToTheEnd(game, afterStep), null));
                    } catch (Throwable failure) {
                        end.complete(new End(Optional.empty(), failure));
                    }
                },
                "game");
        player.setDaemon(true);
        player.start();
        End reached = await(end, player, game);
        if (reached.failure() != null) {
            throw reached.failure();
        }
        return reached.report();
    }

    private End await(CompletableFuture<End> end, Thread player, Game game) throws ExecutionException {
        long limit = moveLimit().toNanos();
        long look = Math.max(1, Math.min(LONGEST_LOOK_MILLISECONDS, moveLimit().toMillis() / 10));
        int time = -1;
        long changed = System.nanoTime();
        while (true) {
            try {
                return end.get(look, TimeUnit.MILLISECONDS);
            } catch (TimeoutException e) {
                // Another thread writes the time; a stale value only makes the limit slightly longer.
                long now = System.nanoTime();
                if (game.getTotalTime() != time) {
                    time = game.getTotalTime();
                    changed = now;
                } else if (now - changed > limit) {
                    String asked = StallNotice.controllerCalledBy(player);
                    player.interrupt();
                    throw new NoAnswer(asked);
                }
            } catch (InterruptedException e) {
                player.interrupt();
                Thread.currentThread().interrupt();
                throw new UserError("interrupted", e);
            }
        }
    }

    private Duration moveLimit() {
        return Objects.requireNonNull(settings.moveLimit(), "only limited games ask for the limit");
    }

    private static RuntimeException unchecked(Throwable failure) {
        if (failure instanceof Error error) {
            throw error;
        }
        return failure instanceof RuntimeException runtime ? runtime : new UndeclaredThrowableException(failure);
    }

    private Outcome finished(Game game, int number, Optional<TimedReport> report) {
        Optional<GameFailure> failure = report.flatMap(timed -> failureIn(timed, number));
        return new Outcome(game.getScore(), game.getTotalTime(), true, failure, report);
    }

    private Optional<GameFailure> failureIn(TimedReport report, int number) {
        Throwable thrown = report.pacMan().failure();
        String controller = settings.pacMan().name();
        if (thrown == null) {
            thrown = report.ghosts().failure();
            controller = settings.ghosts().name();
        }
        return thrown == null
                ? Optional.empty()
                : Optional.of(new GameFailure(number, -1, controller, threw(thrown), Optional.of(thrown)));
    }

    private static Outcome failed(Game game, int number, Throwable failure) {
        ControllerFailure report = ControllerFailure.in(failure).orElse(null);
        if (report != null) {
            Throwable thrown = report == failure ? Objects.requireNonNull(report.getCause()) : failure;
            return failed(game, number, report.controllerName(), threw(thrown), thrown);
        }
        if (failure instanceof UserError error) {
            // A controller could not be created; the message names it.
            return failed(game, number, "", String.valueOf(error.getMessage()), null);
        }
        if (failure instanceof VirtualMachineError error) {
            return failed(game, number, "a controller", threw(error), error);
        }
        throw unchecked(failure);
    }

    private static Outcome failed(Game game, int number, String controller, String what, @Nullable Throwable thrown) {
        GameFailure failure =
                new GameFailure(number, game.getTotalTime(), controller, what, Optional.ofNullable(thrown));
        return new Outcome(0, game.getTotalTime(), false, Optional.of(failure), Optional.empty());
    }

    private static String threw(Throwable thrown) {
        return PlainText.shown(thrown) + MissingMember.explanation(thrown);
    }

    private static void pause(int milliseconds) {
        try {
            Thread.sleep(milliseconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
