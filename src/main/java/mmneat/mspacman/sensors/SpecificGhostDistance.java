package mmneat.mspacman.sensors;

/**
 * Steps in this direction to a given ghost, in [0, 1]; 1 while it is in the lair. Not part of the published experiments.
 *
 * @param ghost Blinky 0, Pinky 1, Inky 2, Sue 3
 */
record SpecificGhostDistance(int ghost) implements DistanceSensor {

    private static final String[] NAMES = {"Blinky", "Pinky", "Inky", "Sue"};

    @Override
    public String label() {
        return "Distance to " + NAMES[ghost];
    }

    @Override
    public int steps(Observation observation) {
        return observation.isOutside(ghost) ? observation.distanceToGhost(ghost) : -1;
    }
}
