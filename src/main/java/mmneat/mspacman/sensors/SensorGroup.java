package mmneat.mspacman.sensors;

/**
 * A group of sensors that a network has or lacks as a whole. The name in brackets at each group is the parameter of the
 * command line that switches it (docs/parameters.md).
 *
 * <p>Source: docs/specification/original-options.md, sections 3.1 and 3.2.
 */
public enum SensorGroup {
    /** Distance of each ghost by its number; with {@link #APPROACHING}, whether it approaches ({@code specific}). */
    NUMBERED_GHOSTS,
    /**
     * Distance of the nth nearest ghost of either kind, n from 1 to 4 ({@code specificGhostProximityOrder}). {@link
     * #APPROACHING}, {@link #TRAPPED}, {@link #TIME_VERSUS_DISTANCE} and {@link #EDIBLE} add sensors of these ghosts.
     */
    NEAREST_GHOSTS,
    /**
     * Distances of the nth nearest threat and of the nth nearest edible ghost, n from 1 to 4 ({@code
     * specificGhostEdibleThreatSplit}). {@link #APPROACHING} and {@link #TRAPPED} add sensors of these ghosts.
     */
    NEAREST_OF_EACH_KIND,
    /** Whether a ghost approaches, in all three groups of ghosts ({@code incoming}). */
    APPROACHING,
    /** Whether no junction lies before a ghost, in the two groups of nearest ghosts ({@code trapped}). */
    TRAPPED,
    /** Edible time against distance of the nth nearest ghost; needs {@link #NEAREST_GHOSTS} ({@code eTimeVsGDis}). */
    TIME_VERSUS_DISTANCE,
    /**
     * Whether the nth nearest ghost is edible; needs {@link #NEAREST_GHOSTS}. The command line adds this group only to
     * games in which ghosts are not imprisoned while others are edible ({@code imprisonedWhileEdible}).
     */
    EDIBLE,
    /**
     * Proportions of edible ghosts and of edible time. The command line adds this group unless ghosts stay edible for
     * ever ({@code infiniteEdibleTime}).
     */
    EDIBLE_PROPORTIONS,
    /** Number of safe moves at the next junction, {@link Observation#safeOptionsAfterJunction} ({@code highLevel}). */
    OPTIONS_AFTER_JUNCTION
}
