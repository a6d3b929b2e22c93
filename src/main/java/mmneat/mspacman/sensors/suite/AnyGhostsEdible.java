package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.Observation;

/** "Any Ghosts Edible?": 1 if a ghost is edible, else 0. */
record AnyGhostsEdible() implements CommonSensor {

    @Override
    public String label() {
        return "Some Ghost Edible";
    }

    @Override
    public double sense(Observation observation) {
        return observation.highestEdibleTime() > 0 ? 1 : 0;
    }
}
