package mmneat.mspacman.sensors;

/** A sensor that is 1 if something holds, else 0. */
interface FlagSensor extends GradedSensor {

    boolean holds(Observation observation);

    @Override
    default int grade(Observation observation) {
        return holds(observation) ? 1 : 0;
    }

    @Override
    default int grades() {
        return 2;
    }

    @Override
    default double value(int grade) {
        return grade;
    }
}
