package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.FlagSensor;
import mmneat.mspacman.sensors.Observation;

/**
 * "nth Nearest Ghost Path Has Junctions?", inverted as in the published experiments: 1 if the way to the ghost has no
 * junction, nor does the ghost stand on one, else 0; 0 if there is no such ghost.
 *
 * @param n rank of the ghost among those outside the lair by distance in this direction, from 0
 */
record GhostTrapped(int n) implements FlagSensor {

    @Override
    public String label() {
        return n + " Closest Ghost Trapped";
    }

    @Override
    public boolean holds(Observation observation) {
        int ghost = observation.nthNearestGhost(n);
        return ghost >= 0 && observation.isTrapped(ghost);
    }
}
