package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.Observation;

/** "Proportion Power Pills": power pills left / power pills of the maze, in [0, 1]; 0 in a maze without any. */
record ProportionPowerPills() implements CommonSensor {

    @Override
    public String label() {
        return "Portion Power Pill Remaining";
    }

    @Override
    public double sense(Observation observation) {
        // A drawn maze may have none.
        return (double) observation.powerPillsLeft() / Math.max(1, observation.powerPillsOfMaze());
    }
}
