package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.FlagSensor;
import mmneat.mspacman.sensors.Observation;

/**
 * "nth Nearest Ghost Edible?": 1 if the ghost is edible, else 0; 0 if there is no such ghost.
 *
 * @param n rank of the ghost among those outside the lair by distance in this direction, from 0
 */
record GhostEdible(int n) implements FlagSensor {

    @Override
    public String label() {
        return n + " Closest Ghost Edible";
    }

    @Override
    public boolean holds(Observation observation) {
        int ghost = observation.nthNearestGhost(n);
        return ghost >= 0 && observation.isEdible(ghost);
    }
}
