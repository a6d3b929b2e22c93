package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.GradedSensor;
import mmneat.mspacman.sensors.Observation;

/**
 * "Max Pills in 30 Steps": the largest number of pills on a walk of {@code steps} steps that starts in this direction
 * and never turns back. It is divided by {@code steps} / 4 rounded up (8 for 30 steps: a straight corridor has a pill
 * at every fourth step). Power pills do not count. The divisor scales usual values to [0, 1]; it is not a maximum, and
 * where pills are closer together the value exceeds 1.
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
