package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.DistanceSensor;
import mmneat.mspacman.sensors.Observation;

/** "Nearest Pill Distance": steps in this direction to the nearest pill that is left, in [0, 1]; 1 if none is left. */
record NearestPillDistance() implements DistanceSensor {

    @Override
    public String label() {
        return "Distance to 0 Nearest Pill";
    }

    @Override
    public int steps(Observation observation) {
        return observation.nearestPill();
    }
}
