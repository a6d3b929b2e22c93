package mmneat.mspacman.sensors;

/**
 * A sensor that has only so many values, numbered from 0. Its values and their hyperbolic tangents are kept in tables,
 * so that sensing is one look-up.
 */
public interface GradedSensor extends Sensor {

    /** Number of different values. */
    int grades();

    /** The value with a number in [0, {@link #grades()}). */
    double value(int grade);

    /** Number of the value in an observation. */
    int grade(Observation observation);

    @Override
    default double sense(Observation observation) {
        return value(grade(observation));
    }
}
