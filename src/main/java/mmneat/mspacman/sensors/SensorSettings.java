package mmneat.mspacman.sensors;

import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;

/**
 * The choice of sensors of a network. Immutable; {@link #blended()} and {@link #imprisoned()} are the published
 * choices.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 4.1, and docs/specification/original-options.md, section 3.
 * The names are those of the parameters.
 *
 * @param groups the groups of sensors that the network has
 * @param junctionsToSense how many of the nearest junctions' distances are sensed, at least 1
 * @param smallStepSimDepth steps of the walks along which pills and junctions are counted, 1 to {@value #DEEPEST}
 * @param edibleTime edible time of the first level, by which times are scaled, at least 1
 * @param closePowerPillDistance distance below which a power pill is close
 * @param own sensors of your own, which follow the others
 */
public record SensorSettings(
        Set<SensorGroup> groups,
        int junctionsToSense,
        int smallStepSimDepth,
        int edibleTime,
        double closePowerPillDistance,
        List<Sensor> own) {

    /** Distance below which a power pill is close in the published experiments; no parameter changes it. */
    public static final double CLOSE_POWER_PILL_DISTANCE = 10;

    /** Maximum length of walks in steps; there are too many longer ones. */
    static final int DEEPEST = 60;

    private static final Set<SensorGroup> IMPRISONED = EnumSet.of(
            SensorGroup.NEAREST_GHOSTS,
            SensorGroup.APPROACHING,
            SensorGroup.TRAPPED,
            SensorGroup.EDIBLE_PROPORTIONS,
            SensorGroup.OPTIONS_AFTER_JUNCTION);

    public SensorSettings {
        if (junctionsToSense < 1) {
            throw new IllegalArgumentException("junctionsToSense must be at least 1, is " + junctionsToSense);
        }
        if (smallStepSimDepth < 1 || smallStepSimDepth > DEEPEST) {
            throw new IllegalArgumentException(
                    "smallStepSimDepth must be from 1 to " + DEEPEST + ", is " + smallStepSimDepth);
        }
        if (edibleTime < 1) {
            throw new IllegalArgumentException("edibleTime must be at least 1, is " + edibleTime);
        }
        groups = Collections.unmodifiableSet(
                groups.isEmpty() ? EnumSet.noneOf(SensorGroup.class) : EnumSet.copyOf(groups));
        own = List.copyOf(own);
    }

    /** The 30 sensors of the blended version. */
    public static SensorSettings blended() {
        return imprisoned().with(SensorGroup.EDIBLE);
    }

    /** The 26 sensors of the interleaved and isolated versions, where ghosts are imprisoned while others are edible. */
    public static SensorSettings imprisoned() {
        return new SensorSettings(IMPRISONED, 1, 30, 200, CLOSE_POWER_PILL_DISTANCE, List.of());
    }

    /**
     * The 38 sensors of the published experiments with separate sensors for threats and for edible ghosts, the same in
     * all versions of the task. Source: docs/specification/original-options.md, section 1.
     */
    public static SensorSettings split() {
        return imprisoned().with(SensorGroup.NEAREST_OF_EACH_KIND).without(SensorGroup.NEAREST_GHOSTS);
    }

    /** Whether a group of sensors is there. */
    public boolean has(SensorGroup group) {
        return groups.contains(group);
    }

    /** The same with another group of sensors. */
    public SensorSettings with(SensorGroup group) {
        EnumSet<SensorGroup> more = EnumSet.of(group);
        more.addAll(groups);
        return withGroups(more);
    }

    /** The same without a group of sensors. */
    public SensorSettings without(SensorGroup group) {
        EnumSet<SensorGroup> fewer = EnumSet.allOf(SensorGroup.class);
        fewer.retainAll(groups);
        fewer.remove(group);
        return withGroups(fewer);
    }

    private SensorSettings withGroups(Set<SensorGroup> others) {
        return new SensorSettings(others, junctionsToSense, smallStepSimDepth, edibleTime, closePowerPillDistance, own);
    }
}
