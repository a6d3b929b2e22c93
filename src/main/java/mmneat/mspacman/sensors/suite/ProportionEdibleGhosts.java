package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.Observation;

/** "Proportion Edible Ghosts": edible ghosts / 4, in [0, 1]. */
record ProportionEdibleGhosts() implements CommonSensor {

    @Override
    public String label() {
        return "Portion Edible Ghost Remaining";
    }

    @Override
    public double sense(Observation observation) {
        return (double) observation.edibleGhosts() / Observation.GHOSTS;
    }
}
