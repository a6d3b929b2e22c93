package mmneat.mspacman.sensors;

/** "Bias": always 1. */
record Bias() implements Sensor {

    @Override
    public String label() {
        return "Bias";
    }

    @Override
    public boolean isDirectional() {
        return false;
    }

    @Override
    public double sense(Observation observation) {
        return 1;
    }
}
