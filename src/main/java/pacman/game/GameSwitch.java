package pacman.game;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;

/**
 * Optional rules that MM-NEAT's tasks switch on for a game in {@link GameRules}. {@link Game} has setters for those
 * that the original changes during a game. All are off in the competition; the sentence at each constant says what
 * happens when it is on.
 *
 * <p>Source: docs/specification/simulator.md, section 7.
 */
public enum GameSwitch {
    /** Ghosts leave the lair edible. */
    EXIT_LAIR_EDIBLE,
    /** Eating everything does not end a level. */
    END_ONLY_ON_TIME_LIMIT,
    /** Ghosts leave the lair at a random junction. */
    RANDOM_LAIR_EXIT,
    /** Ghosts leave the lair at recorded locations ({@link GhostRules#ghostLocations}). */
    LAIR_EXIT_DATABASE,
    /** When one ghost leaves the lair, all do. */
    SIMULTANEOUS_LAIR_EXIT,
    /** Ghosts leave the lair in the first step of a level. */
    GHOSTS_START_OUTSIDE_LAIR,
    /** A ghost that would leave the lair later in a level starts the next level instead. */
    ONLY_ONE_LAIR_EXIT,
    /** A level ends when no power pill is left and no ghost is edible. */
    END_AFTER_GHOST_EATING_CHANCES,
    /** The corridors of power pills hold no pills. */
    REMOVE_PILLS_NEAR_POWER_PILLS,
    /** There are no pills. */
    WITHOUT_PILLS,
    /** There are no power pills. */
    WITHOUT_POWER_PILLS,
    /** A level ends when no power pill is left. */
    END_AFTER_POWER_PILLS_EATEN,
    /** Ghosts stay edible until they are eaten. */
    INFINITE_EDIBLE_TIME,
    /** No ghost leaves the lair while another is edible. */
    IMPRISONED_WHILE_EDIBLE,
    /** Ghosts do not reverse at random. */
    WITHOUT_RANDOM_REVERSALS,
    /** Eating a power pill ends the game unless all active ghosts are threats. */
    DIE_ON_IMPROPER_POWER_PILL_EATING;

    /** The switches of the pill-eating game of the isolated task ({@link GameRules#isolatedPills}). */
    public static final Set<GameSwitch> PILL_TASK =
            Collections.unmodifiableSet(EnumSet.of(REMOVE_PILLS_NEAR_POWER_PILLS, WITHOUT_POWER_PILLS));

    /** The switches of the ghost-eating games of the isolated task ({@link GameRules#isolatedGhosts}). */
    public static final Set<GameSwitch> GHOST_TASK = Collections.unmodifiableSet(EnumSet.of(
            EXIT_LAIR_EDIBLE,
            LAIR_EXIT_DATABASE,
            SIMULTANEOUS_LAIR_EXIT,
            GHOSTS_START_OUTSIDE_LAIR,
            ONLY_ONE_LAIR_EXIT,
            END_AFTER_GHOST_EATING_CHANCES,
            WITHOUT_PILLS,
            WITHOUT_POWER_PILLS));

    /** The switch as a bit of a game's set of switches. */
    final int bit = 1 << ordinal();
}
