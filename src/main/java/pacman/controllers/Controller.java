package pacman.controllers;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import pacman.game.Game;

/**
 * The base class of controllers, which choose moves: called directly or, in timed games, in separate threads.
 *
 * <p>An entry implements only {@link #getMove(Game, long)}. In a timed game one supervisor thread runs this object. For
 * each {@link #update} it starts a worker thread that computes a decision and stores it in {@link #lastMove}. While a
 * worker is busy, further updates only replace the game for the next worker; skipped states are not decided later. If a
 * decision throws an exception, the controller keeps its last answer; Java prints the exception with the thread's name,
 * which is the controller's. Only one worker decides at a time: a new one waits for a worker that is left over from an
 * earlier timed game. {@link Decisions} counts the decisions.
 *
 * <p>Source: the competition's programming interface, release 6.2; docs/specification/controllers.md, section 2.
 *
 * @param <T> {@code MOVE} for Ms. Pac-Man, {@code EnumMap<GHOST, MOVE>} for the ghosts
 */
public abstract class Controller<T> implements Runnable {

    /** The stored answer; null before the first. A long computation may store a provisional answer early. */
    protected volatile @Nullable T lastMove;

    /** The lock of the worker that decides. */
    private final Object deciding = new Object();

    private volatile boolean alive;
    private volatile boolean signalled;
    private volatile boolean computed;
    private volatile boolean busy;
    private volatile @Nullable Game game;
    private volatile long timeDue;

    // Counts since the last revival; see Decisions.
    private int updates;
    private int answeredUpdate;
    private int answers;
    private @Nullable Throwable failure;

    /**
     * Number of revivals. It prevents a worker that is left over from an earlier timed game from storing its answer.
     */
    private volatile int revivals;

    /**
     * Number of terminations. It prevents a supervisor that missed a termination and a revival from serving a later
     * game.
     */
    private volatile int terminations;

    /** Creates a controller that is ready for a timed game. */
    public Controller() {
        alive = true;
    }

    /**
     * Ends the supervisor of a timed game. As in the competition's framework, a controller that is idle then makes one
     * more decision, on the last game that it received; {@link #getMove(Game, long)} must allow for a game that is
     * over. A controller that never received a game decides nothing.
     */
    public final void terminate() {
        synchronized (this) {
            alive = false;
            terminations++;
            signalled = true;
            notifyAll();
        }
    }

    /** Makes the controller ready for another timed game, also after it was terminated or threw an exception. */
    public final void threadRevive() {
        synchronized (this) {
            revivals++;
            alive = true;
            signalled = false;
            computed = false;
            busy = false;
            updates = 0;
            answeredUpdate = 0;
            answers = 0;
            failure = null;
        }
    }

    /**
     * Sets the state for the next decision.
     *
     * @param game a copy that belongs to this controller
     * @param timeDue wall-clock time in milliseconds at which the answer is due
     */
    public final void update(Game game, long timeDue) {
        synchronized (this) {
            this.game = game;
            this.timeDue = timeDue;
            updates++;
            signalled = true;
            computed = false;
            notifyAll();
        }
    }

    /** Returns the stored answer, which may be that of an earlier state; null if there is none yet. */
    public final @Nullable T getMove() {
        return lastMove;
    }

    /** The supervisor: starts a worker per update, until {@link #terminate}. */
    @Override
    public final void run() {
        int before = terminations;
        while (alive) {
            synchronized (this) {
                try {
                    while (!signalled && terminations == before) {
                        wait();
                    }
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                    return;
                }
                if (alive && terminations != before) {
                    return;
                }
                // Nothing to decide on: it was terminated before its first update.
                if (!busy && game != null) {
                    busy = true;
                    int revival = revivals;
                    Thread worker = new Thread(
                            () -> decide(revival), "controller " + getClass().getName());
                    // A decision that never ends must not keep the program from ending.
                    worker.setDaemon(true);
                    worker.start();
                }
                signalled = false;
            }
        }
    }

    /**
     * The work of one worker. If the decision throws an exception, the busy flag remains set, so that no other worker
     * is started.
     */
    private void decide(int revival) {
        synchronized (deciding) {
            Game asked;
            long due;
            int update;
            synchronized (this) {
                if (revival != revivals) {
                    return;
                }
                asked = game;
                due = timeDue;
                update = updates;
            }
            T move;
            try {
                move = getMove(Objects.requireNonNull(asked, "a worker starts after an update"), due);
            } catch (Throwable thrown) {
                noteFailure(revival, thrown);
                throw thrown;
            }
            synchronized (this) {
                if (revival == revivals) {
                    lastMove = move;
                    answeredUpdate = update;
                    answers++;
                    computed = true;
                    busy = false;
                }
            }
        }
    }

    private synchronized void noteFailure(int revival, Throwable thrown) {
        if (revival == revivals) {
            failure = thrown;
        }
    }

    /** Returns a consistent snapshot of the counts. */
    final synchronized Decisions decisions() {
        return new Decisions(updates, answers, answeredUpdate == updates, failure);
    }

    /** Whether a decision has ended since the last {@link #update}. */
    public final boolean hasComputed() {
        return computed;
    }

    /**
     * Computes the decision.
     *
     * @param game a copy of the game that belongs to this controller: it may be advanced, and its generator drawn from
     * @param timeDue wall-clock time in milliseconds at which the answer is due, or -1 for none; for information
     *     only
     */
    public abstract @Nullable T getMove(Game game, long timeDue);
}
