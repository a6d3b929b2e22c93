package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.FlagSensor;
import mmneat.mspacman.sensors.Observation;

/**
 * 1 if the path of a given ghost to Ms. Pac-Man, without turning back, comes in from this direction, else 0; 0 while it
 * is in the lair.
 *
 * <p>Source: docs/specification/original-options.md, section 3.3, block A.
 *
 * @param ghost Blinky 0, Pinky 1, Inky 2, Sue 3
 */
record SpecificGhostApproaching(int ghost) implements FlagSensor {

    @Override
    public String label() {
        return "Ghost " + ghost + " Incoming";
    }

    @Override
    public boolean holds(Observation observation) {
        return observation.isOutside(ghost) && observation.isApproaching(ghost);
    }
}
