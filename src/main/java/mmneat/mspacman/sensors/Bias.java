package mmneat.mspacman.sensors;

/** "Bias": always 1. */
record Bias() implements CommonSensor {

    @Override
    public String label() {
        return "Bias";
    }

    @Override
    public double sense(Observation observation) {
        return 1;
    }
}
