package mmneat.mspacman.sensors.suite;

import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import mmneat.mspacman.sensors.GradedSensor;
import mmneat.mspacman.sensors.Observation;
import mmneat.mspacman.sensors.Sensor;
import mmneat.neat.network.Tanh;
import org.jspecify.annotations.Nullable;
import pacman.game.Game;

/**
 * Reads games with the sensors of a suite: gives the inputs of a network for each direction. One thread uses it.
 *
 * <p>Per time step the state is taken in once ({@link #observe}), then every open direction is sensed: either {@link
 * #sense} for the activations of input neurons, or {@link #inputs} for the values themselves.
 */
public final class NetworkInputs {

    private static final int DIRECTIONS = 4;
    private static final long UNKNOWN = -1;

    private final SensorSuite suite;
    private final Sensor[] sensors;
    private final Observation observation;

    /** Inputs that depend on {@link Observation#commonState} alone. */
    private final int[] common;

    /** Other inputs that do not depend on the direction. */
    private final int[] undirected;

    /** Inputs that depend on the direction. */
    private final int[] directional;

    /** Those of them that are sensed one by one: all, unless {@link #standard} writes the others. */
    private final int[] single;

    private final @Nullable StandardInputs standard;

    /** Hyperbolic tangents of each graded sensor's values; null for other sensors. */
    private final double[][] tangents;

    /** Value of each sensor for the direction that was sensed last. */
    private final double[] inputs;

    /** Hyperbolic tangent of input i for direction d at index d stride + i. */
    private final double[] activations;

    /** The {@link Observation#commonState} for which {@link #common} was sensed last. */
    private long commonState = UNKNOWN;

    NetworkInputs(SensorSuite suite) {
        this.suite = suite;
        observation = new Observation(suite.settings());
        sensors = suite.sensors().toArray(Sensor[]::new);
        common = inputsThat(i -> sensors[i] instanceof CommonSensor);
        undirected = inputsThat(i -> !sensors[i].isDirectional() && !(sensors[i] instanceof CommonSensor));
        directional = inputsThat(i -> sensors[i].isDirectional());
        StandardInputs fast = StandardInputs.serve(suite) ? new StandardInputs(suite) : null;
        standard = fast;
        single = fast == null ? directional : inputsThat(i -> sensors[i].isDirectional() && !fast.writes(i));
        tangents = new double[sensors.length][];
        for (int i = 0; i < sensors.length; i++) {
            tangents[i] = sensors[i] instanceof GradedSensor graded ? StandardInputs.tangents(graded) : null;
        }
        inputs = new double[sensors.length];
        activations = new double[DIRECTIONS * sensors.length];
    }

    private int[] inputsThat(IntPredicate property) {
        return IntStream.range(0, sensors.length).filter(property).toArray();
    }

    /** The sensors in use. */
    public SensorSuite suite() {
        return suite;
    }

    /** The state that was taken in last. */
    public Observation observation() {
        return observation;
    }

    /**
     * Takes in the state of a game.
     *
     * @param game read, not changed
     */
    public void observe(Game game) {
        if (observation.observe(game)) {
            commonState = UNKNOWN;
        }
        senseCommon();
    }

    /** Senses what does not depend on the direction, once the observation is known. */
    void senseCommon() {
        if (observation.commonState() != commonState) {
            commonState = observation.commonState();
            senseUndirected(common);
        }
        senseUndirected(undirected);
    }

    private void senseUndirected(int[] which) {
        for (int i : which) {
            double value = sensors[i].sense(observation);
            // These change seldom, so their tangents are kept.
            if (value != inputs[i]) {
                inputs[i] = value;
                double tangent = Tanh.of(value);
                for (int d = 0; d < DIRECTIONS; d++) {
                    activations[d * sensors.length + i] = tangent;
                }
            }
        }
    }

    /**
     * The values of the sensors in an open direction.
     *
     * @return one value per sensor, valid until the next call
     */
    public double[] inputs(int direction) {
        observation.face(direction);
        for (int i : directional) {
            inputs[i] = sensors[i].sense(observation);
        }
        return inputs;
    }

    /** Computes the activations of input neurons for an open direction; {@link #activations} returns them. */
    public void sense(int direction) {
        observation.face(direction);
        int row = direction * sensors.length;
        if (standard != null) {
            standard.write(observation, activations, row);
        }
        for (int i : single) {
            activations[row + i] = tangents[i] != null
                    ? tangents[i][((GradedSensor) sensors[i]).grade(observation)]
                    : Tanh.of(sensors[i].sense(observation));
        }
    }

    /**
     * Activations of the input neurons, the hyperbolic tangents of the sensors' values; for networks whose inputs have
     * that activation function. Other networks get the values themselves ({@link #inputs}). They are valid for the
     * directions for which {@link #sense} was called in this time step; other directions have old values.
     *
     * @return input i for direction d at index d n + i, where n is the number of sensors; valid until the next step
     */
    public double[] activations() {
        return activations;
    }
}
