package mmneat.cli.options;

import pacman.game.Constants;
import picocli.CommandLine.Option;

/** The option {@code delay=}: the pace of a game in a window. */
public final class DelayOption {

    private static final int LONGEST_MILLISECONDS = 60_000;

    @Option(
            names = "delay",
            paramLabel = "MS",
            defaultValue = "" + Constants.DELAY,
            description = "Milliseconds per step in the window (default: ${DEFAULT-VALUE}).")
    @Range(min = 0, max = LONGEST_MILLISECONDS)
    private int milliseconds;

    /** Milliseconds per step. */
    public int milliseconds() {
        return milliseconds;
    }
}
