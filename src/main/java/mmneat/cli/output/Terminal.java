package mmneat.cli.output;

import picocli.CommandLine.Help.Ansi;

/** The capabilities of the terminal. */
public final class Terminal {

    private Terminal() {}

    /** Whether output goes to a terminal that supports escape sequences for colours and cursor movements. */
    public static boolean understandsEscapes() {
        return understandsEscapes(System.getenv("TERM"), Ansi.AUTO.enabled());
    }

    /**
     * As {@link #understandsEscapes()}, for a given environment.
     *
     * @param type value of the environment variable TERM; null if it is not set
     * @param isTerminal whether output goes to a terminal, according to picocli
     */
    public static boolean understandsEscapes(String type, boolean isTerminal) {
        return isTerminal && !"dumb".equals(type);
    }
}
