package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.Observation;
import mmneat.mspacman.sensors.Sensor;

/**
 * Edible time of the nth nearest ghost against its distance: (edible time - steps) / longest edible time, limited to
 * [-1, 1]. The edible time of a threat is 0. -1 if there is no such ghost.
 *
 * <p>Source: docs/specification/original-options.md, section 3.3, block B.
 *
 * @param n rank of the ghost among those outside the lair by distance in this direction, from 0
 * @param longest edible time of the first level, in steps
 */
record GhostTimeVersusDistance(int n, int longest) implements Sensor {

    @Override
    public String label() {
        return "Edible Time Vs Distance to 0 Nearest " + n + " Closest Ghost";
    }

    @Override
    public double sense(Observation observation) {
        int ghost = observation.nthNearestGhost(n);
        if (ghost < 0) {
            return -1;
        }
        double spare = observation.edibleTime(ghost) - observation.distanceToGhost(ghost);
        return Math.max(-1, Math.min(1, spare / longest));
    }
}
