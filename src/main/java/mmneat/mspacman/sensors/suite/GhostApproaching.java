package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.FlagSensor;
import mmneat.mspacman.sensors.Observation;

/**
 * "nth Nearest Ghost Approaching?": 1 if the ghost's own way to Ms. Pac-Man, without turning back, comes in from this
 * direction, else 0; 0 if there is no such ghost.
 *
 * @param n rank of the ghost among those outside the lair by distance in this direction, from 0
 */
record GhostApproaching(int n) implements FlagSensor {

    @Override
    public String label() {
        return n + " Closest Ghost Incoming";
    }

    @Override
    public boolean holds(Observation observation) {
        int ghost = observation.nthNearestGhost(n);
        return ghost >= 0 && observation.isApproaching(ghost);
    }
}
