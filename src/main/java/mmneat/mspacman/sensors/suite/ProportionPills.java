package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.Observation;

/** "Proportion Pills": pills left / pills of the maze, in [0, 1], even where the game starts with fewer. */
record ProportionPills() implements CommonSensor {

    @Override
    public String label() {
        return "Portion Pill Remaining";
    }

    @Override
    public double sense(Observation observation) {
        return (double) observation.pillsLeft() / observation.pillsOfMaze();
    }
}
