package mmneat.mspacman.sensors.suite;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.stream.Stream;
import mmneat.mspacman.sensors.DrawnMaze;
import mmneat.mspacman.sensors.RandomState;
import mmneat.mspacman.sensors.ReferenceSensors;
import mmneat.mspacman.sensors.SensorGroup;
import mmneat.mspacman.sensors.SensorSettings;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import pacman.maze.MazeGraph;
import pacman.maze.MazeTables;
import pacman.maze.Mazes;

/** Sensors computed from tables equal sensors computed by search, in 180,000 random states. */
class FastSensorsTest {

    private static final int STATES_PER_MAZE = 20_000;

    /** Steps of a walk. */
    private static final int STEPS = 50;

    static Stream<MazeTables> mazes() {
        return Stream.concat(
                Stream.of(0, 1, 2, 3).map(Mazes.standard()::get),
                Stream.of(DrawnMaze.maze(), DrawnMaze.withoutPowerPills()));
    }

    @ParameterizedTest
    @MethodSource("mazes")
    void fastSensors_equalSearchingOnes_inRandomStates(MazeTables maze) {
        compare(maze, SensorSettings.blended(), STATES_PER_MAZE);
    }

    @ParameterizedTest
    @MethodSource("mazes")
    void sensorsOfEachKindOfGhost_equalSearchingOnes_inRandomStates(MazeTables maze) {
        SensorSettings both = SensorSettings.blended().with(SensorGroup.NEAREST_OF_EACH_KIND);
        compare(maze, both, STATES_PER_MAZE / 10);
        compare(maze, both.without(SensorGroup.NEAREST_GHOSTS), STATES_PER_MAZE / 10);
    }

    /** Settings with which all sensors are asked one by one. */
    @ParameterizedTest
    @MethodSource("mazes")
    void sensorsThatThePublishedExperimentsLeaveOut_equalSearchingOnes_inRandomStates(MazeTables maze) {
        compare(
                maze,
                new SensorSettings(EnumSet.allOf(SensorGroup.class), 3, 30, 200, 10, List.of()),
                STATES_PER_MAZE / 10);
    }

    /** What fast sensors keep from one step to the next is right, too. */
    @ParameterizedTest
    @MethodSource("mazes")
    void fastSensors_equalSearchingOnes_alongWalks(MazeTables maze) {
        MazeGraph graph = maze.graph();
        ResumableRandom random = new ResumableRandom(graph.lair());
        SensorSettings settings = SensorSettings.blended();
        SensorSuite suite = SensorSuite.of(settings);
        NetworkInputs senses = suite.newInputs();
        for (int walk = 0; walk < STATES_PER_MAZE / 2 / STEPS; walk++) {
            RandomState state = new RandomState(graph, random);
            int direction = 0;
            for (int step = 0; step < STEPS; step++) {
                compare(maze, settings, state, suite, senses);
                while (!graph.isOpen(state.pacMan, direction) || random.nextInt(10) == 0) {
                    direction = random.nextInt(4);
                }
                state = state.afterStep(graph, direction, random);
            }
        }
    }

    private static void compare(MazeTables maze, SensorSettings settings, int states) {
        ResumableRandom random = new ResumableRandom(maze.graph().nodeCount());
        SensorSuite suite = SensorSuite.of(settings);
        NetworkInputs senses = suite.newInputs();
        for (int i = 0; i < states; i++) {
            compare(maze, settings, new RandomState(maze.graph(), random), suite, senses);
        }
    }

    private static void compare(
            MazeTables maze, SensorSettings settings, RandomState state, SensorSuite suite, NetworkInputs senses) {
        ReferenceSensors reference = new ReferenceSensors(maze, state);
        state.show(senses.observation(), maze);
        senses.senseCommon();
        for (int d = 0; d < 4; d++) {
            if (senses.observation().isOpen(d)) {
                double[] expected = reference.inputs(d, settings);
                double[] inputs = senses.inputs(d);
                if (!Arrays.equals(inputs, expected)) {
                    assertThat(inputs)
                            .as("maze %s, direction %d, %s: %s", maze.graph().name(), d, state, suite.labels(d))
                            .containsExactly(expected);
                }
                senses.sense(d);
                double[] activations =
                        Arrays.copyOfRange(senses.activations(), d * suite.size(), (d + 1) * suite.size());
                for (int input = 0; input < expected.length; input++) {
                    if (activations[input] != StrictMath.tanh(expected[input])) {
                        assertThat(activations[input])
                                .as("activation of %s", suite.labels(d).get(input))
                                .isEqualTo(StrictMath.tanh(expected[input]));
                    }
                }
            }
        }
    }
}
