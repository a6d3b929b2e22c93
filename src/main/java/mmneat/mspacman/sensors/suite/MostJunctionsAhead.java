package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.GradedSensor;
import mmneat.mspacman.sensors.Observation;

/**
 * "Max Junctions in 30 Steps": the largest number of junctions on a walk of {@code steps} steps that starts in this
 * direction and never turns back. It is divided by {@code steps} / 7 rounded up (5 for 30 steps). The divisor scales
 * usual values to [0, 1]; it is not a maximum, and where junctions are close together the value exceeds 1.
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
