package mmneat.mspacman.sensors;

/**
 * 1 if the way of a given ghost to Ms. Pac-Man comes in from this direction, else 0. Not part of the published experiments.
 *
 * @param ghost Blinky 0, Pinky 1, Inky 2, Sue 3
 */
record SpecificGhostApproaching(int ghost) implements FlagSensor {

    private static final String[] NAMES = {"Blinky", "Pinky", "Inky", "Sue"};

    @Override
    public String label() {
        return NAMES[ghost] + " Incoming";
    }

    @Override
    public boolean holds(Observation observation) {
        return observation.isOutside(ghost) && observation.isApproaching(ghost);
    }
}
