package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.DistanceSensor;
import mmneat.mspacman.sensors.Observation;

/**
 * "nth Nearest Ghost Distance": steps in this direction to the ghost, in [0, 1]; 1 if there is no such ghost.
 *
 * @param n rank of the ghost among those outside the lair by distance in this direction, from 0
 */
record GhostDistance(int n) implements DistanceSensor {

    @Override
    public String label() {
        return "Distance to 0 Nearest " + n + " Closest Ghost";
    }

    @Override
    public int steps(Observation observation) {
        int ghost = observation.nthNearestGhost(n);
        return ghost < 0 ? -1 : observation.distanceToGhost(ghost);
    }
}
