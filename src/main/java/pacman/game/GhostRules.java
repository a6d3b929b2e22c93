package pacman.game;

import org.jspecify.annotations.Nullable;

/**
 * The rules for the ghosts of a game: their number, their times and where they leave the lair. Immutable. Times are in
 * game steps.
 *
 * <p>Source: docs/specification/simulator.md, sections 2 and 7.
 *
 * @param activeGhosts number of ghosts that leave the lair, 0 to 4
 * @param edibleTime steps for which ghosts are edible in the first level
 * @param lairTime steps for which an eaten ghost stays in the lair in the first level, at least 2
 * @param ghostLocations where ghosts leave the lair under {@link GameSwitch#LAIR_EXIT_DATABASE}, only in the mazes of
 *     the competition; may be null without that switch
 */
public record GhostRules(
        int activeGhosts,
        int edibleTime,
        int lairTime,
        @Nullable GhostLocations ghostLocations) {

    /** MM-NEAT's defaults: the four ghosts of the competition. */
    static final GhostRules MM_NEAT =
            new GhostRules(Constants.NUM_GHOSTS, Constants.EDIBLE_TIME, Constants.COMMON_LAIR_TIME, null);

    /** @throws IllegalArgumentException if a value is out of its range */
    public GhostRules {
        GameRules.requireRange("activeGhosts", activeGhosts, 0, Constants.NUM_GHOSTS);
        GameRules.requireRange("edibleTime", edibleTime, 0, Integer.MAX_VALUE);
        // The lair time decreases from level to level and must stay at least 1: a ghost without lair time moves, which
        // is impossible in the lair.
        GameRules.requireRange("lairTime", lairTime, 2, Integer.MAX_VALUE);
    }

    public GhostRules withActiveGhosts(int value) {
        return new GhostRules(value, edibleTime, lairTime, ghostLocations);
    }

    public GhostRules withEdibleTime(int value) {
        return new GhostRules(activeGhosts, value, lairTime, ghostLocations);
    }

    public GhostRules withLairTime(int value) {
        return new GhostRules(activeGhosts, edibleTime, value, ghostLocations);
    }

    public GhostRules withGhostLocations(GhostLocations value) {
        return new GhostRules(activeGhosts, edibleTime, lairTime, value);
    }
}
