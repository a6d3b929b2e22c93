package pacman;

import java.util.EnumMap;
import java.util.function.Consumer;
import pacman.controllers.Controller;
import pacman.controllers.Decisions;
import pacman.game.Constants;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * Plays a game in real time: each controller computes in its own thread, and at the end of a tick the game advances by
 * the answers stored so far.
 *
 * <p>Source: docs/specification/controllers.md, sections 2 and 6.2. An interrupt ends the game early (in MM-NEAT it
 * continues).
 */
final class TimedRun {

    /** The rule for the time that a tick waits for the controllers; {@link Executor.Pace} offers the first two. */
    enum Waiting {
        /** Always the full {@value Constants#DELAY} ms. */
        FULL_DELAY,
        /**
         * Until both have answered, at most {@value Constants#DELAY} checks at intervals of {@value
         * Constants#INTERVAL_WAIT} ms.
         */
        UNTIL_ANSWERED,
        /** As {@link #UNTIL_ANSWERED}, then the rest of the delay if both answered in time. */
        FIXED_TIME
    }

    private final Controller<MOVE> pacMan;
    private final Controller<EnumMap<GHOST, MOVE>> ghosts;
    private final Waiting waiting;
    private int steps;
    /** Steps in which a controller had answered the state of that step. */
    private int punctualPacMan;

    private int punctualGhosts;

    TimedRun(Controller<MOVE> pacMan, Controller<EnumMap<GHOST, MOVE>> ghosts, Waiting waiting) {
        this.pacMan = pacMan;
        this.ghosts = ghosts;
        this.waiting = waiting;
    }

    /**
     * Plays until the game is over; then both controllers are terminated, after one more decision.
     *
     * @param afterTick called after each tick with the game
     * @return the punctuality of the controllers, without the decision after the end
     */
    TimedReport play(Game game, Consumer<Game> afterTick) {
        supervise(pacMan);
        supervise(ghosts);
        try {
            while (!game.gameOver()) {
                pacMan.update(game.copy(), System.currentTimeMillis() + Constants.DELAY);
                ghosts.update(game.copy(), System.currentTimeMillis() + Constants.DELAY);
                await();
                steps++;
                punctualPacMan += Decisions.of(pacMan).isUpToDate() ? 1 : 0;
                punctualGhosts += Decisions.of(ghosts).isUpToDate() ? 1 : 0;
                advance(game);
                afterTick.accept(game);
            }
            return report();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return report();
        } finally {
            pacMan.terminate();
            ghosts.terminate();
        }
    }

    /** Advances by the stored answers. An answer of a wrong type is a failure of the controller that gave it. */
    private void advance(Game game) {
        int time = game.getTotalTime();
        Controller<?> asked = pacMan;
        try {
            MOVE move = pacMan.getMove();
            asked = ghosts;
            game.advanceGame(move, ghosts.getMove());
        } catch (Throwable failure) {
            ControllerFailure.report(failure, asked, time);
            throw failure;
        }
    }

    private TimedReport report() {
        return new TimedReport(side(pacMan, punctualPacMan), side(ghosts, punctualGhosts));
    }

    private TimedReport.Side side(Controller<?> controller, int punctual) {
        Decisions decisions = Decisions.of(controller);
        int late = Math.max(0, decisions.answers() - punctual);
        return new TimedReport.Side(steps, late, steps - punctual, decisions.failure());
    }

    private static void supervise(Controller<?> controller) {
        Thread supervisor =
                new Thread(controller, "supervisor of " + controller.getClass().getName());
        supervisor.setDaemon(true);
        supervisor.start();
    }

    private void await() throws InterruptedException {
        if (waiting == Waiting.FULL_DELAY) {
            Thread.sleep(Constants.DELAY);
            return;
        }
        int looks = Constants.DELAY / Constants.INTERVAL_WAIT;
        for (int look = 0; look < looks; look++) {
            Thread.sleep(Constants.INTERVAL_WAIT);
            if (pacMan.hasComputed() && ghosts.hasComputed()) {
                if (waiting == Waiting.FIXED_TIME) {
                    Thread.sleep((long) (looks - look) * Constants.INTERVAL_WAIT);
                }
                return;
            }
        }
    }
}
