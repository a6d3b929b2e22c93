package mmneat.mspacman.sensors;

import java.util.List;

/**
 * Which sensors a network has. Immutable; {@link #blended()} and {@link #imprisoned()} are the published choices.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 4.1. The names are those of the parameters.
 *
 * @param junctionsToSense how many of the nearest junctions' distances are sensed, at least 1
 * @param incoming whether approaching ghosts are sensed
 * @param trapped whether it is sensed that no junction lies before a ghost
 * @param eTimeVsGDis whether ghosts' edible times are compared with their distances
 * @param edible whether it is sensed of each ghost if it is edible: where ghosts are not imprisoned while others are edible
 * @param specific whether each ghost is sensed by name too
 * @param specificGhostEdibleThreatSplit whether threats and edible ghosts are sensed apart too
 * @param smallStepSimDepth steps of the walks along which pills and junctions are counted, 1 to {@value #DEEPEST}
 * @param edibleTimes whether edible ghosts and times are sensed as a whole: unless ghosts stay edible for ever
 * @param edibleTime edible time of the first level, by which times are scaled, at least 1
 * @param closePowerPillDistance distance below which a power pill is close
 * @param highLevel whether the options from the next junction are sensed
 * @param own sensors of one's own, which follow the others
 */
public record SensorSettings(
        int junctionsToSense,
        boolean incoming,
        boolean trapped,
        boolean eTimeVsGDis,
        boolean edible,
        boolean specific,
        boolean specificGhostEdibleThreatSplit,
        int smallStepSimDepth,
        boolean edibleTimes,
        int edibleTime,
        double closePowerPillDistance,
        boolean highLevel,
        List<Sensor> own) {

    /** Walks get too many beyond this depth. */
    static final int DEEPEST = 60;

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
        own = List.copyOf(own);
    }

    /** The 30 sensors of the blended version. */
    public static SensorSettings blended() {
        return new SensorSettings(1, true, true, false, true, false, false, 30, true, 200, 10, true, List.of());
    }

    /** The 26 sensors of the interleaved and isolated versions, where ghosts are imprisoned while others are edible. */
    public static SensorSettings imprisoned() {
        return new SensorSettings(1, true, true, false, false, false, false, 30, true, 200, 10, true, List.of());
    }
}
