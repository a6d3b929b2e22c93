package mmneat.contest;

/** How long the controllers of a contest may take for an answer. */
public enum Timing {
    /** As long as they like; they are asked directly. */
    NONE,
    /** 40 ms per step by the clock, however soon they answer. */
    REAL_TIME,
    /** 40 ms at most; the next step comes when both have answered. */
    UNTIL_ANSWERED
}
