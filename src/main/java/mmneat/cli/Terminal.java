package mmneat.cli;

import picocli.CommandLine.Help.Ansi;

/** What the terminal can show. */
final class Terminal {

    private Terminal() {}

    /** Whether output goes to a terminal that understands escape sequences: colours and movements of the cursor. */
    static boolean understandsEscapes() {
        return understandsEscapes(System.getenv("TERM"), Ansi.AUTO.enabled());
    }

    /**
     * The same for given circumstances.
     *
     * @param type value of the variable TERM; null if it is not set
     * @param isTerminal whether output goes to a terminal, as far as picocli knows
     */
    static boolean understandsEscapes(String type, boolean isTerminal) {
        return isTerminal && !"dumb".equals(type);
    }
}
