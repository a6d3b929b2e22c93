package mmneat.mspacman.sensors;

/**
 * A group of sensors that a network has or lacks as a whole. The name in brackets at each group is the parameter of the
 * command line that switches it (docs/parameters.md).
 *
 * <p>Source: docs/specification/original-options.md, sections 3.1 and 3.2.
 */
public enum SensorGroup {
    /** Distance, and approach, of each ghost by its number ({@code specific}). */
    NUMBERED_GHOSTS,
    /** Distance, and more, of the nth nearest ghost of either kind ({@code specificGhostProximityOrder}). */
    NEAREST_GHOSTS,
    /**
     * Distance, and more, of the nth nearest threat and of the nth nearest edible ghost ({@code
     * specificGhostEdibleThreatSplit}).
     */
    NEAREST_OF_EACH_KIND,
    /** Whether a ghost approaches, in all three groups of ghosts ({@code incoming}). */
    APPROACHING,
    /** Whether no junction lies before a ghost, in the two groups of nearest ghosts ({@code trapped}). */
    TRAPPED,
    /** Edible time against distance of the nth nearest ghost; needs {@link #NEAREST_GHOSTS} ({@code eTimeVsGDis}). */
    TIME_VERSUS_DISTANCE,
    /**
     * Whether the nth nearest ghost is edible; needs {@link #NEAREST_GHOSTS}. Sensed where ghosts are not imprisoned
     * while others are edible ({@code imprisonedWhileEdible}).
     */
    EDIBLE,
    /**
     * Proportions of edible ghosts and of edible time; sensed unless ghosts stay edible for ever ({@code
     * infiniteEdibleTime}).
     */
    EDIBLE_PROPORTIONS,
    /** Options from the next junction ({@code highLevel}). */
    OPTIONS_AFTER_JUNCTION
}
