package mmneat.contest;

/**
 * The time limit for an answer of a controller. Games with {@link #NONE} are called untimed, all others timed. In a
 * timed game each controller computes in a thread of its own; if it is late, its last answer is used again.
 */
public enum Timing {
    /** No limit: controllers are called directly. */
    NONE,
    /** Exactly 40 ms per step, even if the controllers answer earlier. */
    REAL_TIME,
    /** At most 40 ms per step: the next step starts when both have answered. */
    UNTIL_ANSWERED
}
