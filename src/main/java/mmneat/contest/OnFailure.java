package mmneat.contest;

/** The rule for a game in which a controller failed. */
public enum OnFailure {
    /** The contest ends; the finished games are reported. */
    STOP,
    /** The game is left out. */
    SKIP,
    /** The game counts with a score of 0. */
    SCORE0
}
