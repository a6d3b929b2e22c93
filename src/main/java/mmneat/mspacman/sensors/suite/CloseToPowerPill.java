package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.Observation;

/**
 * "Close to Power Pill?": 1 if a power pill that is not eaten is less than {@code closeness} steps away in any
 * direction, else 0.
 *
 * @param closeness distance in steps
 */
record CloseToPowerPill(double closeness) implements CommonSensor {

    @Override
    public String label() {
        return "Within " + closeness + " of Power Pill?";
    }

    @Override
    public double sense(Observation observation) {
        return observation.isCloseToPowerPill() ? 1 : 0;
    }
}
