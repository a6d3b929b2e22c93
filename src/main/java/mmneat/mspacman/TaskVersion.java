package mmneat.mspacman;

import java.util.Locale;

/** The three versions of the task that the paper compares. */
public enum TaskVersion {
    /** Threats and edible ghosts at the same time: one full game per trial. */
    BLENDED,
    /** Ghosts stay in the lair while others are edible: one full game per trial. */
    INTERLEAVED,
    /** A game of eating pills among threats, and four games of eating ghosts, per trial. */
    ISOLATED;

    /** As it is written in commands and titles. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
