package mmneat.mspacman.sensors.suite;

import java.util.function.IntToDoubleFunction;
import mmneat.mspacman.sensors.DistanceSensor;
import mmneat.mspacman.sensors.GradedSensor;
import mmneat.mspacman.sensors.Observation;
import mmneat.mspacman.sensors.SensorGroup;
import mmneat.mspacman.sensors.SensorSettings;

/**
 * A fast form of the sensors of the published experiments that depend on the direction: it computes the activations of
 * all of them in one method. They are equal to those that the single sensors give.
 */
final class StandardInputs {

    /*
     * Calling two dozen sensors one by one costs more than most of their computations. Here they are written out in the
     * order of the inputs, with the same tables of tangents. A test checks that both forms are equal.
     */

    private final boolean nearest;
    private final boolean ofEachKind;
    private final boolean incoming;
    private final boolean trapped;
    private final boolean edible;
    private final double[] distance;
    private final double[] flag;
    private final double[] pills;
    private final double[] junctions;
    private final double[] options;

    /** Input of the junctions ahead, the last of those that are written one after the other. */
    private final int junctionsInput;

    /** Input of the options from the next junction; -1 if there is none. */
    private final int optionsInput;

    /** @param suite one that this class {@link #serve}s */
    StandardInputs(SensorSuite suite) {
        SensorSettings settings = suite.settings();
        nearest = settings.has(SensorGroup.NEAREST_GHOSTS);
        ofEachKind = settings.has(SensorGroup.NEAREST_OF_EACH_KIND);
        incoming = settings.has(SensorGroup.APPROACHING);
        trapped = settings.has(SensorGroup.TRAPPED);
        edible = settings.has(SensorGroup.EDIBLE);
        distance = tangents(new NearestPillDistance());
        flag = tangents(new GhostEdible(0));
        pills = tangents(new MostPillsAhead(settings.smallStepSimDepth()));
        junctions = tangents(new MostJunctionsAhead(settings.smallStepSimDepth()));
        options = tangents(new OptionsAfterJunction());
        junctionsInput = junctionsInput(suite);
        optionsInput = suite.sensors().indexOf(new OptionsAfterJunction());
    }

    /** Whether the sensors of a suite are, up to the junctions ahead, those that this class computes. */
    static boolean serve(SensorSuite suite) {
        SensorSettings settings = suite.settings();
        int perGhost = 1 + count(settings, SensorGroup.APPROACHING) + count(settings, SensorGroup.TRAPPED);
        int nearest = count(settings, SensorGroup.NEAREST_GHOSTS) * (perGhost + count(settings, SensorGroup.EDIBLE));
        int ofEachKind = 2 * count(settings, SensorGroup.NEAREST_OF_EACH_KIND) * perGhost;
        return settings.junctionsToSense() == 1
                && !settings.has(SensorGroup.TIME_VERSUS_DISTANCE)
                && !settings.has(SensorGroup.NUMBERED_GHOSTS)
                && junctionsInput(suite) == 3 + Observation.GHOSTS * (nearest + ofEachKind) + 2;
    }

    private static int count(SensorSettings settings, SensorGroup group) {
        return settings.has(group) ? 1 : 0;
    }

    private static int junctionsInput(SensorSuite suite) {
        return suite.sensors().indexOf(new MostJunctionsAhead(suite.settings().smallStepSimDepth()));
    }

    /** Whether {@link #write} writes an input; it leaves out sensors that are not directional, except the bias. */
    boolean writes(int input) {
        return input <= junctionsInput || input == optionsInput;
    }

    /** Hyperbolic tangents of a sensor's values. */
    static double[] tangents(GradedSensor sensor) {
        IntToDoubleFunction tangent = grade -> StrictMath.tanh(sensor.value(grade));
        return java.util.stream.IntStream.range(0, sensor.grades())
                .mapToDouble(tangent)
                .toArray();
    }

    /**
     * Writes the activations for the direction that an observation looks at.
     *
     * @param row place of the first input, the bias
     */
    void write(Observation observation, double[] activations, int row) {
        int at = row + 1;
        activations[at++] = distance(observation.nearestPill());
        activations[at++] = distance(observation.nearestPowerPill());
        activations[at++] = distance(observation.nearestJunction());
        if (nearest) {
            at = writeNearestGhosts(observation, activations, at);
        }
        if (ofEachKind) {
            at = writeGhostsOfEachKind(observation, activations, at);
        }
        activations[at++] = pills[observation.mostPillsAhead()];
        activations[at] = junctions[observation.mostJunctionsAhead()];
        if (optionsInput >= 0) {
            activations[row + optionsInput] = options[observation.safeOptionsAfterJunction()];
        }
    }

    /** Returns the place after the last input that it wrote. */
    private int writeNearestGhosts(Observation observation, double[] activations, int first) {
        int at = first;
        for (int n = 0; n < Observation.GHOSTS; n++) {
            int ghost = observation.nthNearestGhost(n);
            boolean exists = ghost >= 0;
            int flags = exists ? observation.ghostFlags(ghost) : 0;
            activations[at++] = distance(exists ? observation.distanceToGhost(ghost) : -1);
            if (incoming) {
                activations[at++] = flag[flags & 1];
            }
            if (trapped) {
                activations[at++] = flag[flags >> 1 & 1];
            }
            if (edible) {
                activations[at++] = flag[flags >> 2];
            }
        }
        return at;
    }

    /** Returns the place after the last input that it wrote. */
    private int writeGhostsOfEachKind(Observation observation, double[] activations, int first) {
        int perRank = 2 + (incoming ? 2 : 0) + (trapped ? 2 : 0);
        int end = first + Observation.GHOSTS * perRank;
        int threat = first;
        int edibleGhost = first + 1;
        for (int n = 0; n < Observation.GHOSTS; n++) {
            int ghost = observation.nthNearestGhost(n);
            if (ghost < 0) {
                break;
            }
            if (observation.isEdible(ghost)) {
                writeGhostOfKind(observation, ghost, activations, edibleGhost);
                edibleGhost += perRank;
            } else {
                writeGhostOfKind(observation, ghost, activations, threat);
                threat += perRank;
            }
        }
        for (; threat < end; threat += perRank) {
            writeAbsence(activations, threat);
        }
        for (; edibleGhost < end; edibleGhost += perRank) {
            writeAbsence(activations, edibleGhost);
        }
        return end;
    }

    /** The two kinds take turns, so one kind has every other input. */
    private void writeGhostOfKind(Observation observation, int ghost, double[] activations, int first) {
        int at = first;
        activations[at] = distance(observation.distanceToGhost(ghost));
        if (incoming) {
            at += 2;
            activations[at] = flag[observation.isApproaching(ghost) ? 1 : 0];
        }
        if (trapped) {
            activations[at + 2] = flag[observation.isTrapped(ghost) ? 1 : 0];
        }
    }

    private void writeAbsence(double[] activations, int first) {
        int at = first;
        activations[at] = distance(-1);
        if (incoming) {
            at += 2;
            activations[at] = flag[0];
        }
        if (trapped) {
            activations[at + 2] = flag[0];
        }
    }

    private double distance(int steps) {
        return distance[Math.min(steps & Integer.MAX_VALUE, DistanceSensor.FAR)];
    }
}
