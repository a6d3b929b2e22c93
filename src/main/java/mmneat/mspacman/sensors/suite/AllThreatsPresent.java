package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.Observation;

/** "All Threat Ghosts Present?": 1 if all four ghosts are threats outside the lair, else 0. */
record AllThreatsPresent() implements CommonSensor {

    @Override
    public String label() {
        return "All Threats Present";
    }

    @Override
    public double sense(Observation observation) {
        return observation.threats() == Observation.GHOSTS ? 1 : 0;
    }
}
