package mmneat.mspacman.sensors;

/**
 * A sensor of a distance: steps / 200, and 1 from 200 steps on or if the target does not exist. Range [0, 1].
 *
 * <p>Source: docs/specification/mspacman-task.md, sections 4.4 and 4.6.
 */
public interface DistanceSensor extends GradedSensor {

    /** Distance in steps from which on the value is 1. */
    int FAR = 200;

    /** Steps to the target, or -1 if it does not exist. */
    int steps(Observation observation);

    @Override
    default int grade(Observation observation) {
        return Math.min(steps(observation) & Integer.MAX_VALUE, FAR);
    }

    @Override
    default int grades() {
        return FAR + 1;
    }

    @Override
    default double value(int grade) {
        return (double) grade / FAR;
    }
}
