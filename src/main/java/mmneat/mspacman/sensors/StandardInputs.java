package mmneat.mspacman.sensors;

import java.util.function.IntToDoubleFunction;

/**
 * The directional sensors of the published experiments, all at once: the activations that the single sensors give too.
 */
final class StandardInputs {

    /*
     * Asking two dozen sensors one by one costs more than most of them have to do. Here they are written out in the order of
     * the inputs, with the same tables of tangents; a test holds both forms together.
     */

    private final boolean incoming;
    private final boolean trapped;
    private final boolean edible;
    private final double[] distance;
    private final double[] flag;
    private final double[] pills;
    private final double[] junctions;
    private final double[] options;

    /** Input of the options from the next junction, or NONE. */
    private final int optionsInput;

    StandardInputs(SensorSuite suite) {
        SensorSettings settings = suite.settings();
        incoming = settings.incoming();
        trapped = settings.trapped();
        edible = settings.edible();
        distance = tangents(new NearestPillDistance());
        flag = tangents(new GhostEdible(0));
        pills = tangents(new MostPillsAhead(settings.smallStepSimDepth()));
        junctions = tangents(new MostJunctionsAhead(settings.smallStepSimDepth()));
        options = tangents(new OptionsAfterJunction());
        optionsInput = suite.sensors().indexOf(new OptionsAfterJunction());
    }

    /** Whether a choice of sensors has no directional ones but those that are written here, before those of one's own. */
    static boolean serve(SensorSettings settings) {
        return settings.junctionsToSense() == 1
                && !settings.eTimeVsGDis()
                && !settings.specific()
                && !settings.specificGhostEdibleThreatSplit();
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
        for (int n = 0; n < Observation.GHOSTS; n++) {
            int ghost = observation.nthNearestGhost(n);
            boolean exists = ghost >= 0;
            activations[at++] = distance(exists ? observation.distanceToGhost(ghost) : -1);
            if (incoming) {
                activations[at++] = flag[exists && observation.isApproaching(ghost) ? 1 : 0];
            }
            if (trapped) {
                activations[at++] = flag[exists && observation.isTrapped(ghost) ? 1 : 0];
            }
            if (edible) {
                activations[at++] = flag[exists && observation.isEdible(ghost) ? 1 : 0];
            }
        }
        activations[at++] = pills[observation.mostPillsAhead()];
        activations[at] = junctions[observation.mostJunctionsAhead()];
        if (optionsInput >= 0) {
            activations[row + optionsInput] = options[observation.safeOptionsAfterJunction()];
        }
    }

    private double distance(int steps) {
        return distance[Math.min(steps & Integer.MAX_VALUE, DistanceSensor.FAR)];
    }
}
