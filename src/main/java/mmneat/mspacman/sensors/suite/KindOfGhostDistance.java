package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.DistanceSensor;
import mmneat.mspacman.sensors.GhostKind;
import mmneat.mspacman.sensors.Observation;

/**
 * Steps in this direction to the nth nearest ghost of a kind, in [0, 1]; 1 if there is no such ghost.
 *
 * <p>Source: docs/specification/original-options.md, section 3.3, block C.
 *
 * @param n rank among the ghosts of this kind outside the lair by distance in this direction, from 0
 * @param kind the ghosts that count
 */
record KindOfGhostDistance(int n, GhostKind kind) implements DistanceSensor {

    @Override
    public String label() {
        return "Distance to 0 Nearest " + n + " Closest " + kind.label() + " Ghost";
    }

    @Override
    public int steps(Observation observation) {
        int ghost = observation.nthNearestGhost(n, kind);
        return ghost < 0 ? -1 : observation.distanceToGhost(ghost);
    }
}
