package mmneat.mspacman.sensors;

/**
 * One input of the network: a number that describes the game, for one direction in which Ms. Pac-Man might go.
 *
 * <p>To add a sensor of your own, write a class that implements this interface and has a public constructor without
 * arguments. The program finds it by its full class name in the parameter {@code ownSensors}; a program that uses the
 * library passes an object in {@link SensorSettings#own}. docs/sensors.md has an example. A sensor keeps no state: the
 * same observation always gives the same value.
 */
public interface Sensor {

    /** Name of the input in logs and in drawings of networks. */
    String label();

    /**
     * Whether the value depends on the direction, as by default. A sensor that returns false is computed once per time
     * step instead of once per direction.
     */
    default boolean isDirectional() {
        return true;
    }

    /**
     * The value of the input. It should lie in [-1, 1], because the input neuron applies its activation function (tanh)
     * to it.
     *
     * @param observation the state of the game and the direction that is looked at
     */
    double sense(Observation observation);
}
