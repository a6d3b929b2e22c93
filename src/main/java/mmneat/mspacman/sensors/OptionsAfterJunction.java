package mmneat.mspacman.sensors;

/**
 * "Options From Next Junction": ways on from the next junction in this direction whose own next junctions Ms. Pac-Man
 * reaches before any ghost, divided by 4; 0 if already the next junction is not safe. One of 0, 0.25, 0.5, 0.75.
 *
 * <p>Source: docs/specification/mspacman-task.md, sections 4.10 and 4.11.
 */
record OptionsAfterJunction() implements GradedSensor {

    @Override
    public String label() {
        return "Options After Junction";
    }

    @Override
    public int grade(Observation observation) {
        return observation.safeOptionsAfterJunction();
    }

    @Override
    public int grades() {
        return 5;
    }

    @Override
    public double value(int grade) {
        return grade / 4.0;
    }
}
