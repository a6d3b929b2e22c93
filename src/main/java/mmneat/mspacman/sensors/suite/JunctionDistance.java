package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.DistanceSensor;
import mmneat.mspacman.sensors.Observation;

/**
 * "Nearest Junction Distance": steps in this direction to the nearest junction (rank 0), the next nearest, ..., in (0,
 * 1].
 *
 * @param rank from 0
 */
record JunctionDistance(int rank) implements DistanceSensor {

    @Override
    public String label() {
        return "Distance to " + rank + " Nearest Junction";
    }

    @Override
    public int steps(Observation observation) {
        return rank == 0 ? observation.nearestJunction() : observation.nthNearestJunction(rank);
    }
}
