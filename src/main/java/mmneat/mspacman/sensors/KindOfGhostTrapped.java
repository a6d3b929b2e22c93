package mmneat.mspacman.sensors;

/**
 * 1 if the nth nearest ghost is of a kind and the way to it has no junction, else 0. Not part of the published experiments.
 *
 * @param n rank of the ghost among those outside the lair by distance in this direction, from 0
 * @param edible whether edible ghosts count, else threats
 */
record KindOfGhostTrapped(int n, boolean edible) implements FlagSensor {

    private int ghost(Observation observation) {
        int ghost = observation.nthNearestGhost(n);
        return ghost >= 0 && observation.isEdible(ghost) == edible ? ghost : -1;
    }

    @Override
    public String label() {
        return n + " Closest " + (edible ? "Edible" : "Threat") + " Ghost Trapped";
    }

    @Override
    public boolean holds(Observation observation) {
        int ghost = ghost(observation);
        return ghost >= 0 && observation.isTrapped(ghost);
    }
}
