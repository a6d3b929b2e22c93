package mmneat.mspacman.sensors;

/**
 * "Max Pills in 30 Steps": the most pills on a walk of so many steps that starts in this direction and never turns
 * back, divided by the number of pills that a straight corridor of that length holds (8 for 30 steps); power pills do
 * not count. Range [0, 1], rarely more.
 *
 * @param steps length of the walks
 */
record MostPillsAhead(int steps) implements GradedSensor {

    @Override
    public String label() {
        return "Max Num Pill " + steps + " Steps Ahead";
    }

    @Override
    public int grade(Observation observation) {
        return observation.mostPillsAhead();
    }

    @Override
    public int grades() {
        return steps + 1;
    }

    @Override
    public double value(int grade) {
        return grade / Math.ceil(steps / 4.0);
    }
}
