package mmneat.mspacman.sensors;

/** A sensor that is the same in all directions and depends on nothing but {@link Observation#commonState}. */
interface CommonSensor extends Sensor {

    @Override
    default boolean isDirectional() {
        return false;
    }
}
