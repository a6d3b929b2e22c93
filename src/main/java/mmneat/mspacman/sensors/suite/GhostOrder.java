package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.Observation;

/**
 * The orders in which sensors number ghosts from 0. Except for {@link #BY_NUMBER}, only ghosts outside the lair count,
 * nearest first in the direction of the observation.
 *
 * <p>Source: docs/specification/original-options.md, section 3.3, blocks A to C.
 */
enum GhostOrder {
    /** Blinky 0, Pinky 1, Inky 2, Sue 3. */
    BY_NUMBER,
    /** All ghosts. */
    NEAREST,
    /** The ghosts that catch Ms. Pac-Man. */
    NEAREST_THREAT,
    /** The ghosts that Ms. Pac-Man can eat. */
    NEAREST_EDIBLE;

    /** Number of the ghost at place n of this order, or -1 if there is none outside the lair. */
    int ghost(int n, Observation observation) {
        return switch (this) {
            case BY_NUMBER -> observation.isOutside(n) ? n : -1;
            case NEAREST -> observation.nthNearestGhost(n);
            case NEAREST_THREAT -> observation.nthNearestThreat(n);
            case NEAREST_EDIBLE -> observation.nthNearestEdibleGhost(n);
        };
    }

    /** The original's words for the ghost at place n of this order in labels of sensors. */
    String label(int n) {
        return switch (this) {
            case BY_NUMBER -> "Ghost " + n;
            case NEAREST -> n + " Closest Ghost";
            case NEAREST_THREAT -> n + " Closest Threat Ghost";
            case NEAREST_EDIBLE -> n + " Closest Edible Ghost";
        };
    }
}
