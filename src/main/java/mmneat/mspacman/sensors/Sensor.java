package mmneat.mspacman.sensors;

/**
 * One input of the network: a number that says something about the game, for one direction in which Ms. Pac-Man might
 * go.
 *
 * <p>To add a sensor of one's own, write a class that implements this interface and has a public constructor without
 * arguments; docs/sensors.md shows how. A sensor keeps no state: the same observation always gives the same value.
 */
public interface Sensor {

    /** What the input means, as logs and drawings of networks name it. */
    String label();

    /**
     * Whether the value depends on the direction. Other sensors are asked once per time step instead of once per
     * direction.
     */
    default boolean isDirectional() {
        return true;
    }

    /** The value, best in [-1, 1]: the input neuron applies its activation function (tanh) to it. */
    double sense(Observation observation);
}
