package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.DistanceSensor;
import mmneat.mspacman.sensors.Observation;

/**
 * "Nearest Power Pill Distance": steps in this direction to the nearest power pill that is left, in [0, 1]; 1 if none
 * is.
 */
record NearestPowerPillDistance() implements DistanceSensor {

    @Override
    public String label() {
        return "Distance to 0 Nearest Power Pill";
    }

    @Override
    public int steps(Observation observation) {
        return observation.nearestPowerPill();
    }
}
