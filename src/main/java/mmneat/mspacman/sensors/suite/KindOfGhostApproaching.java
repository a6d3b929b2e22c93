package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.FlagSensor;
import mmneat.mspacman.sensors.GhostKind;
import mmneat.mspacman.sensors.Observation;

/**
 * 1 if the path of the nth nearest ghost of a kind to Ms. Pac-Man, without turning back, comes in from this direction,
 * else 0; 0 if there is no such ghost.
 *
 * <p>Source: docs/specification/original-options.md, section 3.3, block C.
 *
 * @param n rank among the ghosts of this kind outside the lair by distance in this direction, from 0
 * @param kind the ghosts that count
 */
record KindOfGhostApproaching(int n, GhostKind kind) implements FlagSensor {

    @Override
    public String label() {
        return n + " Closest " + kind.label() + " Ghost Incoming";
    }

    @Override
    public boolean holds(Observation observation) {
        int ghost = observation.nthNearestGhost(n, kind);
        return ghost >= 0 && observation.isApproaching(ghost);
    }
}
