package mmneat.mspacman.sensors;

/** A sensor with two values: 1 if a fact about the game holds, else 0. */
public interface FlagSensor extends GradedSensor {

    /** Whether the fact holds in an observation: then the value is 1, else 0. */
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
