package mmneat.contest;

import java.io.PrintWriter;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import pacman.game.Game;

/**
 * A timer that reports an untimed game without steps for a while. It is for untimed games without {@link
 * ContestSettings#moveLimit}: there nothing else detects a controller that never answers. The game goes on.
 */
final class StallNotice implements AutoCloseable {

    private static final String ASKING = "pacman.UntimedRun";

    private final PrintWriter notes;
    private final Thread player;
    private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor(StallNotice::thread);

    private volatile @Nullable Game game;

    // The state at the last check; only the timer thread uses these fields.
    private @Nullable Game gameSeen;
    private int timeSeen;
    private boolean told;

    /**
     * Starts to watch the games that the calling thread plays.
     *
     * @param milliseconds time between two checks; a game that has made no step between them is stalled
     */
    StallNotice(PrintWriter notes, long milliseconds) {
        this.notes = notes;
        player = Thread.currentThread();
        clock.scheduleAtFixedRate(() -> look(milliseconds), milliseconds, milliseconds, TimeUnit.MILLISECONDS);
    }

    private static Thread thread(Runnable looks) {
        Thread thread = new Thread(looks, "stall notice");
        thread.setDaemon(true);
        return thread;
    }

    /** Sets the game to watch; null for none. */
    void watch(@Nullable Game next) {
        game = next;
    }

    private void look(long milliseconds) {
        Game now = game;
        if (now == null) {
            return;
        }
        // Another thread writes the time without synchronisation; a stale value only delays the notice slightly.
        int time = now.getTotalTime();
        boolean goesOn = now != gameSeen || time != timeSeen;
        gameSeen = now;
        timeSeen = time;
        if (goesOn) {
            told = false;
        } else if (!told) {
            told = true;
            notes.println("mmneat: " + controllerCalledBy(player) + " has not answered for " + milliseconds / 1000
                    + " s at time " + time + " of the game; timed=true plays on without an answer, moveLimit=SECONDS"
                    + " ends the game, Ctrl-C stops the program");
            notes.flush();
        }
    }

    /** Returns the class of the controller whose method the playing thread has called to get a move. */
    static String controllerCalledBy(Thread player) {
        StackTraceElement asked = null;
        for (StackTraceElement frame : player.getStackTrace()) {
            if (frame.getClassName().equals(ASKING)) {
                return asked == null ? "a controller" : asked.getClassName();
            }
            asked = frame;
        }
        return "a controller";
    }

    @Override
    public void close() {
        clock.shutdownNow();
    }
}
