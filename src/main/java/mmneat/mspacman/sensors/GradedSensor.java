package mmneat.mspacman.sensors;

/**
 * A sensor that has a small, fixed number of different values, numbered from 0. Its values and their hyperbolic
 * tangents are kept in tables, so that sensing is one look-up. To implement it, write the three methods below and
 * {@link #label}.
 */
public interface GradedSensor extends Sensor {

    /** Number of different values; the table has so many entries. */
    int grades();

    /** The value with a number in [0, {@link #grades()}). */
    double value(int grade);

    /** Number in [0, {@link #grades()}) of the value that the sensor has in an observation. */
    int grade(Observation observation);

    @Override
    default double sense(Observation observation) {
        return value(grade(observation));
    }
}
