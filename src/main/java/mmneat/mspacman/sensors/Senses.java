package mmneat.mspacman.sensors;

import java.util.stream.IntStream;
import pacman.game.Game;
import pacman.game.internal.MazeTables;

/**
 * Senses games with the sensors of a suite: gives the inputs of a network for each direction. One thread uses it.
 *
 * <p>Per time step the state is taken in once, then the inputs are asked for per open direction.
 */
public final class Senses {

    private final SensorSuite suite;
    private final Situation situation = new Situation();

    /** Numbers of the inputs that depend on the direction, and of those that do not. */
    private final int[] directional;

    private final int[] common;
    private final double[] inputs;
    private final double[] activations;

    /** The sensors by input; null in {@link #graded} where a sensor has no table. */
    private final Sensor[] sensors;

    private final GradedSensor[] graded;

    /** Hyperbolic tangent of each value of a graded sensor. */
    private final double[][] tangents;

    /** Value of each input of the common ones whose tangent is in {@link #activations}. */
    private final double[] knownValue;

    private MazeTables knownMaze;
    private SensorTables tables;

    Senses(SensorSuite suite) {
        this.suite = suite;
        int size = suite.size();
        sensors = suite.sensors().toArray(Sensor[]::new);
        graded = new GradedSensor[size];
        tangents = new double[size][];
        inputs = new double[size];
        activations = new double[size];
        knownValue = new double[size];
        directional = numbers(true);
        common = numbers(false);
        for (int i = 0; i < size; i++) {
            if (sensors[i] instanceof GradedSensor known) {
                graded[i] = known;
                tangents[i] = new double[known.grades()];
                for (int grade = 0; grade < tangents[i].length; grade++) {
                    tangents[i][grade] = StrictMath.tanh(known.value(grade));
                }
            }
        }
    }

    private int[] numbers(boolean ofDirectional) {
        return IntStream.range(0, sensors.length)
                .filter(i -> sensors[i].isDirectional() == ofDirectional)
                .toArray();
    }

    /** The sensors in use. */
    public SensorSuite suite() {
        return suite;
    }

    /** The state that was taken in last. */
    public Situation situation() {
        return situation;
    }

    /**
     * Takes in the state of a game.
     *
     * @param game read, not changed
     */
    public void observe(Game game) {
        MazeTables maze = game.mazeTables();
        if (maze != knownMaze) {
            knownMaze = maze;
            tables = suite.tables(maze);
        }
        situation.observe(game, tables);
        senseCommon();
    }

    /** Senses what does not depend on the direction, after the situation has been set. */
    void senseCommon() {
        for (int i : common) {
            double value = sensors[i].sense(situation);
            inputs[i] = value;
            if (value != knownValue[i]) {
                knownValue[i] = value;
                activations[i] = StrictMath.tanh(value);
            }
        }
    }

    /**
     * What the sensors say about an open direction.
     *
     * @return one value per sensor, valid until the next call
     */
    public double[] inputs(int direction) {
        situation.face(direction);
        for (int i : directional) {
            inputs[i] = sensors[i].sense(situation);
        }
        return inputs;
    }

    /**
     * The hyperbolic tangents of what the sensors say about an open direction: the activations of input neurons.
     *
     * @return one value per sensor, valid until the next call
     */
    public double[] activations(int direction) {
        situation.face(direction);
        for (int i : directional) {
            activations[i] = graded[i] != null
                    ? tangents[i][graded[i].grade(situation)]
                    : StrictMath.tanh(sensors[i].sense(situation));
        }
        return activations;
    }
}
