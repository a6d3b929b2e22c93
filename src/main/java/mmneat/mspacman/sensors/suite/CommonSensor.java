package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.Observation;
import mmneat.mspacman.sensors.Sensor;

/**
 * A sensor that is the same in all directions and depends only on {@link Observation#commonState}: the numbers of
 * pills, power pills, edible ghosts and threats, the highest edible time, and whether a power pill is close. While that
 * state does not change, the value is not computed again.
 */
interface CommonSensor extends Sensor {

    @Override
    default boolean isDirectional() {
        return false;
    }
}
