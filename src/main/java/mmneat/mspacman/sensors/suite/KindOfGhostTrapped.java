package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.FlagSensor;
import mmneat.mspacman.sensors.GhostKind;
import mmneat.mspacman.sensors.Observation;

/**
 * 1 if the path to the nth nearest ghost of a kind has no junction, nor does the ghost stand on one, else 0; 0 if there
 * is no such ghost. The original's label does not name the kind.
 *
 * <p>Source: docs/specification/original-options.md, sections 3.3, block C, and 3.4.
 *
 * @param n rank among the ghosts of this kind outside the lair by distance in this direction, from 0
 * @param kind the ghosts that count
 */
record KindOfGhostTrapped(int n, GhostKind kind) implements FlagSensor {

    @Override
    public String label() {
        return n + " Closest Ghost Trapped";
    }

    @Override
    public boolean holds(Observation observation) {
        int ghost = observation.nthNearestGhost(n, kind);
        return ghost >= 0 && observation.isTrapped(ghost);
    }
}
