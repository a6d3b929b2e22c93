package mmneat.mspacman.sensors;

/**
 * Steps in this direction to the nth nearest ghost if it is of a kind, in [0, 1]; otherwise 1. Not part of the published experiments.
 *
 * @param n rank of the ghost among those outside the lair by distance in this direction, from 0
 * @param edible whether edible ghosts count, else threats
 */
record KindOfGhostDistance(int n, boolean edible) implements DistanceSensor {

    private int ghost(Observation observation) {
        int ghost = observation.nthNearestGhost(n);
        return ghost >= 0 && observation.isEdible(ghost) == edible ? ghost : -1;
    }

    @Override
    public String label() {
        return "Distance to 0 Nearest " + n + " Closest " + (edible ? "Edible" : "Threat") + " Ghost";
    }

    @Override
    public int steps(Observation observation) {
        int ghost = ghost(observation);
        return ghost < 0 ? -1 : observation.distanceToGhost(ghost);
    }
}
