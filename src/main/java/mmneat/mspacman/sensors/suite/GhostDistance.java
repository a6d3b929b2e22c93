package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.DistanceSensor;
import mmneat.mspacman.sensors.Observation;

/**
 * "nth Nearest Ghost Distance": steps in this direction to the ghost, in [0, 1]; 1 if there is no such ghost.
 *
 * @param order the order that numbers the ghosts
 * @param n place of the ghost in this order, from 0
 */
record GhostDistance(GhostOrder order, int n) implements DistanceSensor {

    @Override
    public String label() {
        return "Distance to 0 Nearest " + order.label(n);
    }

    @Override
    public int steps(Observation observation) {
        int ghost = order.ghost(n, observation);
        return ghost < 0 ? -1 : observation.distanceToGhost(ghost);
    }
}
