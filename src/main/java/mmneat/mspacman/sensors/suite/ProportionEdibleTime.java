package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.Observation;

/**
 * "Proportion Edible Time": longest edible time of any ghost / edible time of the first level, in [0, 1]; 0 if none is
 * edible.
 *
 * @param longest edible time of the first level
 */
record ProportionEdibleTime(int longest) implements CommonSensor {

    @Override
    public String label() {
        return "3 Highest Edible Time";
    }

    @Override
    public double sense(Observation observation) {
        return (double) observation.highestEdibleTime() / longest;
    }
}
