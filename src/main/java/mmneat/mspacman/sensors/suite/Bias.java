package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.Observation;

/** "Bias": always 1. */
record Bias() implements CommonSensor {

    @Override
    public String label() {
        return "Bias";
    }

    @Override
    public double sense(Observation observation) {
        return 1;
    }
}
