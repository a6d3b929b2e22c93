package mmneat.mspacman.sensors;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.stream.Stream;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import pacman.maze.MazeTables;
import pacman.maze.Mazes;

/** Sensors that look up equal sensors that search, in 120,000 random states. */
class FastSensorsTest {

    private static final int STATES_PER_MAZE = 20_000;

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

    private static void compare(MazeTables maze, SensorSettings settings, int states) {
        ResumableRandom random = new ResumableRandom(maze.graph().nodeCount());
        SensorSuite suite = SensorSuite.of(settings);
        SensorTables tables = suite.tables(maze);
        NetworkInputs senses = suite.newInputs();
        for (int i = 0; i < states; i++) {
            RandomState state = new RandomState(maze.graph(), random);
            ReferenceSensors reference = new ReferenceSensors(maze, state);
            state.show(senses, tables);
            for (int d = 0; d < 4; d++) {
                if (senses.observation().isOpen(d)) {
                    double[] expected = reference.inputs(d, settings);
                    double[] inputs = senses.inputs(d);
                    if (!Arrays.equals(inputs, expected)) {
                        assertThat(inputs)
                                .as(
                                        "maze %s, direction %d, %s: %s",
                                        maze.graph().name(), d, state, suite.labels(d))
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
}
