package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.FlagSensor;
import mmneat.mspacman.sensors.Observation;

/**
 * "nth Nearest Ghost Approaching?": 1 if the ghost's own path to Ms. Pac-Man, without turning back, comes in from this
 * direction, else 0; 0 if there is no such ghost.
 *
 * @param order the order that numbers the ghosts
 * @param n place of the ghost in this order, from 0
 */
record GhostApproaching(GhostOrder order, int n) implements FlagSensor {

    @Override
    public String label() {
        return order.label(n) + " Incoming";
    }

    @Override
    public boolean holds(Observation observation) {
        int ghost = order.ghost(n, observation);
        return ghost >= 0 && observation.isApproaching(ghost);
    }
}
