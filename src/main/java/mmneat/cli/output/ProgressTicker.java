package mmneat.cli.output;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import mmneat.evolution.DaemonThreads;

/**
 * Shows the progress of a long command. A terminal shows the current lines, redrawn in place. A log file or a dumb
 * terminal receives the lines after 5 s, and then at intervals that double up to 10 minutes.
 */
public final class ProgressTicker {

    private static final long TERMINAL_MILLIS = 500;
    private static final Duration FIRST_PLAIN = Duration.ofSeconds(5);
    private static final Duration LAST_PLAIN = Duration.ofMinutes(10);

    private static final String UP_AND_CLEAR = "\u001b[1A\u001b[2K";

    /**
     * Turns off line wrapping: a line wider than the terminal must stay one line, because lines are cleared one by one.
     */
    private static final String WITHOUT_WRAPPING = "\u001b[?7l";

    private static final String WRAPPING_AGAIN = "\u001b[?7h";

    private final PrintWriter out;
    private final Supplier<List<String>> lines;
    private final ScheduledExecutorService clock =
            Executors.newSingleThreadScheduledExecutor(DaemonThreads.named("progress"));

    private int linesOnTerminal;
    private boolean isClosed;

    private ProgressTicker(PrintWriter out, Supplier<List<String>> lines) {
        this.out = out;
        this.lines = lines;
    }

    /**
     * Starts to show lines.
     *
     * @param lines returns the current lines, or none if there is no progress yet; the ticker's thread calls it
     */
    public static ProgressTicker start(PrintWriter out, Supplier<List<String>> lines) {
        ProgressTicker ticker = new ProgressTicker(out, lines);
        if (Terminal.understandsEscapes()) {
            ticker.clock.scheduleAtFixedRate(ticker::redraw, TERMINAL_MILLIS, TERMINAL_MILLIS, TimeUnit.MILLISECONDS);
        } else {
            ticker.scheduleLines(FIRST_PLAIN);
        }
        return ticker;
    }

    /** Work that may fail. */
    public interface Work<T, E extends Exception> {
        T run() throws E;
    }

    /** Shows lines while work is done, and returns the result of the work. */
    public static <T, E extends Exception> T during(PrintWriter out, Supplier<List<String>> lines, Work<T, E> work)
            throws E {
        ProgressTicker ticker = start(out, lines);
        try {
            return work.run();
        } finally {
            ticker.close();
        }
    }

    private void scheduleLines(Duration after) {
        Duration next = after.multipliedBy(2);
        clock.schedule(
                () -> {
                    print();
                    scheduleLines(next.compareTo(LAST_PLAIN) < 0 ? next : LAST_PLAIN);
                },
                after.toMillis(),
                TimeUnit.MILLISECONDS);
    }

    private synchronized void print() {
        if (!isClosed) {
            lines.get().forEach(out::println);
            out.flush();
        }
    }

    private synchronized void redraw() {
        if (isClosed) {
            return;
        }
        List<String> now = lines.get();
        out.print(UP_AND_CLEAR.repeat(linesOnTerminal) + WITHOUT_WRAPPING);
        now.forEach(out::println);
        out.print(WRAPPING_AGAIN);
        out.flush();
        linesOnTerminal = now.size();
    }

    /** Stops showing progress and removes the last lines from the terminal. Closing twice has no effect. */
    public synchronized void close() {
        if (!isClosed) {
            isClosed = true;
            clock.shutdownNow();
            out.print(UP_AND_CLEAR.repeat(linesOnTerminal));
            out.flush();
        }
    }
}
