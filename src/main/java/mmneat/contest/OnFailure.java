package mmneat.contest;

/** The rule for a game in which a controller failed: end the contest, leave out the game, or count it with score 0. */
public enum OnFailure {
    /** The contest ends; the finished games are reported. */
    STOP,
    /** The game is left out. */
    SKIP,
    /** The game counts with a score of 0. */
    SCORE0
}
