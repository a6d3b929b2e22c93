package pacman.controllers;

import pacman.game.Game;

/**
 * Decides on moves, either when asked directly or, in timed games, in threads of its own.
 *
 * <p>An entry implements {@link #getMove(Game, long)} alone. In a timed game one supervisor thread runs this object; for
 * each {@link #update} it starts a worker thread that computes a decision and stores it in {@link #lastMove}. While a
 * worker is busy, further updates only replace the game that the next worker will see: nothing is caught up afterwards.
 * A worker whose decision throws leaves the controller frozen on its last answer; the thread's name, which Java prints
 * with the exception, is the controller's. Workers never decide at the same time: one that is left over from an earlier timed
 * game is waited for. {@link Decisions} counts what the workers did.
 *
 * <p>Source: the competition's programming interface, release 6.2; docs/specification/controllers.md, section 2.
 *
 * @param <T> {@code MOVE} for Ms. Pac-Man, {@code EnumMap<GHOST, MOVE>} for the ghosts
 */
public abstract class Controller<T> implements Runnable {

    /** The stored answer; a long computation may set it early to save a provisional one. Null until then. */
    protected volatile T lastMove;

    /** Held by the worker that decides. */
    private final Object deciding = new Object();

    private volatile boolean alive;
    private volatile boolean signalled;
    private volatile boolean computed;
    private volatile boolean busy;
    private volatile Game game;
    private volatile long timeDue;

    // Since the last revival; see Decisions.
    private int updates;
    private int answeredUpdate;
    private int answers;
    private Throwable failure;

    /** Grows with each revival: a worker that is left over from an earlier timed game stores nothing in this one. */
    private volatile int revivals;

    /** Grows with each end: a supervisor that sleeps through an end and a revival serves no later game. */
    private volatile int terminations;

    /** A controller that is ready for a timed game. */
    public Controller() {
        alive = true;
    }

    /** Ends the supervisor; an idle controller still makes one more decision, on the last game. */
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
     * Hands over the state to decide on.
     *
     * @param game a copy that belongs to this controller
     * @param timeDue wall-clock time in milliseconds by which the answer is wanted
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

    /** The stored answer, whatever game it was computed for; null if there is none yet. */
    public final T getMove() {
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
                if (!busy) {
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

    /** One worker's life. If the decision throws, the busy flag stays up, so that no other is started. */
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
                move = getMove(asked, due);
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

    /** A consistent view of what the workers did. */
    final synchronized Decisions decisions() {
        return new Decisions(updates, answers, answeredUpdate == updates, failure);
    }

    /** Whether a decision has ended since the last {@link #update}. */
    public final boolean hasComputed() {
        return computed;
    }

    /**
     * The decision.
     *
     * @param game a copy of the game that belongs to this controller: it may be advanced, and its generator drawn from
     * @param timeDue wall-clock time in milliseconds by which the answer is wanted, or -1; for information only
     */
    public abstract T getMove(Game game, long timeDue);
}
