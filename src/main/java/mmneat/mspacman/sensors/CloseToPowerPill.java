package mmneat.mspacman.sensors;

/**
 * "Close to Power Pill?": 1 if a power pill that is left is fewer than so many steps away, in whatever direction, else
 * 0.
 *
 * @param closeness in steps
 */
record CloseToPowerPill(double closeness) implements CommonSensor {

    @Override
    public String label() {
        return "Within " + closeness + " of Power Pill?";
    }

    @Override
    public double sense(Observation observation) {
        return observation.isCloseToPowerPill() ? 1 : 0;
    }
}
