package mmneat.mspacman.sensors;

/**
 * A sensor of a distance: steps / 200, and 1 from 200 steps on or if what is looked for does not exist. Range [0, 1].
 *
 * <p>Source: docs/specification/mspacman-task.md, sections 4.4 and 4.6.
 */
interface DistanceSensor extends GradedSensor {

    /** Distance from which on all are the same. */
    int FAR = 200;

    /** Steps, or -1 if what is looked for does not exist. */
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
