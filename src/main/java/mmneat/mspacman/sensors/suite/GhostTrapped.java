package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.FlagSensor;
import mmneat.mspacman.sensors.Observation;

/**
 * "nth Nearest Ghost Path Has Junctions?", inverted as in the published experiments: 1 if the path to the ghost has no
 * junction, nor does the ghost stand on one, else 0; 0 if there is no such ghost.
 *
 * <p>Quirk: the original's label does not name the order. Source: docs/specification/original-options.md, section 3.4.
 *
 * @param order the order that numbers the ghosts
 * @param n place of the ghost in this order, from 0
 */
record GhostTrapped(GhostOrder order, int n) implements FlagSensor {

    @Override
    public String label() {
        return GhostOrder.NEAREST.label(n) + " Trapped";
    }

    @Override
    public boolean holds(Observation observation) {
        int ghost = order.ghost(n, observation);
        return ghost >= 0 && observation.isTrapped(ghost);
    }
}
