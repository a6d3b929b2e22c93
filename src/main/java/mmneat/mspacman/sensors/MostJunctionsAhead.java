package mmneat.mspacman.sensors;

/**
 * "Max Junctions in 30 Steps": the most junctions on a walk of so many steps that starts in this direction and never
 * turns back, divided by a seventh of the steps (5 for 30 steps). Range [0, 1], rarely more.
 *
 * @param steps length of the walks
 */
record MostJunctionsAhead(int steps) implements GradedSensor {

    @Override
    public String label() {
        return "Max Num Junction " + steps + " Steps Ahead";
    }

    @Override
    public int grade(Observation observation) {
        return observation.mostJunctionsAhead();
    }

    @Override
    public int grades() {
        return steps + 1;
    }

    @Override
    public double value(int grade) {
        return grade / Math.ceil(steps / 7.0);
    }
}
