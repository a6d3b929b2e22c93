package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.DistanceSensor;
import mmneat.mspacman.sensors.Observation;

/**
 * Steps in this direction to a given ghost, in [0, 1]; 1 while it is in the lair.
 *
 * <p>Source: docs/specification/original-options.md, section 3.3, block A.
 *
 * @param ghost Blinky 0, Pinky 1, Inky 2, Sue 3
 */
record SpecificGhostDistance(int ghost) implements DistanceSensor {

    @Override
    public String label() {
        return "Distance to 0 Nearest Ghost " + ghost;
    }

    @Override
    public int steps(Observation observation) {
        return observation.isOutside(ghost) ? observation.distanceToGhost(ghost) : -1;
    }
}
