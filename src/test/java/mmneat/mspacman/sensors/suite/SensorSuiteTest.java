package mmneat.mspacman.sensors.suite;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import mmneat.mspacman.sensors.Observation;
import mmneat.mspacman.sensors.Sensor;
import mmneat.mspacman.sensors.SensorGroup;
import mmneat.mspacman.sensors.SensorSettings;
import org.junit.jupiter.api.Test;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GameRules;

class SensorSuiteTest {

    /** A sensor as a user would write it: manhattan distance to the lair exit, whatever the direction. */
    public static final class ExitDistance implements Sensor {
        @Override
        public String label() {
            return "Distance to Lair Exit";
        }

        @Override
        public boolean isDirectional() {
            return false;
        }

        @Override
        public double sense(Observation observation) {
            Game game = observation.game();
            return game.getManhattanDistance(observation.pacManNode(), game.getGhostInitialNodeIndex()) / 200.0;
        }
    }

    /** A sensor of a user's that depends on the direction. */
    public static final class DirectionNumber implements Sensor {
        @Override
        public String label() {
            return "Direction";
        }

        @Override
        public double sense(Observation observation) {
            return observation.direction() / 4.0;
        }
    }

    private static SensorSettings everything(List<Sensor> own) {
        return new SensorSettings(EnumSet.allOf(SensorGroup.class), 3, 20, 200, 10, own);
    }

    private static SensorSettings blendedWith(Sensor... own) {
        SensorSettings blended = SensorSettings.blended();
        return new SensorSettings(blended.groups(), 1, 30, 200, blended.closePowerPillDistance(), List.of(own));
    }

    @Test
    void publishedSuites_haveTheOriginalsNumberOfInputs() {
        assertThat(SensorSuite.of(SensorSettings.blended()).size()).isEqualTo(30);
        assertThat(SensorSuite.of(SensorSettings.imprisoned()).size()).isEqualTo(26);
    }

    @Test
    void labels_nameTheDirection_ofDirectionalSensors() {
        assertThat(SensorSuite.of(SensorSettings.blended()).labels(-1))
                .startsWith("Bias", "Distance to 0 Nearest Pill in dir -1")
                .contains("Portion Pill Remaining")
                .endsWith("Options After Junction in dir -1");
    }

    @Test
    void switches_addAndDropSensors() {
        SensorSettings bare = new SensorSettings(EnumSet.noneOf(SensorGroup.class), 1, 30, 200, 10, List.of());

        assertThat(SensorSuite.of(bare).size()).isEqualTo(4 + 2 + 2 + 3);
        // Bias, pill, power pill, 3 junctions; 8 by number; 4 times (5 plain and 6 by kind); 10 of the whole.
        assertThat(SensorSuite.of(everything(List.of())).size()).isEqualTo(6 + 8 + 4 * 11 + 10);
    }

    /** Source: docs/specification/original-options.md, section 3.2, second table. */
    @Test
    void splitSensors_haveTheOriginalsNumberOfInputs() {
        for (SensorSettings published : List.of(SensorSettings.blended(), SensorSettings.imprisoned())) {
            SensorSettings both = published.with(SensorGroup.NEAREST_OF_EACH_KIND);
            int size = SensorSuite.of(published).size();

            assertThat(SensorSuite.of(both).size()).isEqualTo(size + 24);
            assertThat(SensorSuite.of(both.without(SensorGroup.NEAREST_GHOSTS)).size())
                    .isEqualTo(38);
            SensorSettings timed =
                    published.with(SensorGroup.TIME_VERSUS_DISTANCE).with(SensorGroup.NUMBERED_GHOSTS);
            assertThat(SensorSuite.of(timed).size()).isEqualTo(size + 12);
            assertThat(SensorSuite.of(timed.with(SensorGroup.NEAREST_OF_EACH_KIND))
                            .size())
                    .isEqualTo(size + 36);
        }
    }

    @Test
    void ownSensors_areSensedBehindTheOthers_withAndWithoutTheFastForm() {
        for (boolean fast : new boolean[] {true, false}) {
            Sensor[] own = {new ExitDistance(), new DirectionNumber()};
            SensorSuite suite = SensorSuite.of(fast ? blendedWith(own) : everything(List.of(own)));
            NetworkInputs senses = suite.newInputs();
            Game game = new Game(0, GameRules.blended());
            senses.observe(game);
            int left = MOVE.LEFT.ordinal();

            double[] inputs = senses.inputs(left);
            senses.sense(left);

            int size = suite.size();
            double distance = game.getManhattanDistance(978, 498) / 200.0;
            assertThat(inputs[size - 2]).isEqualTo(distance);
            assertThat(inputs[size - 1]).isEqualTo(0.75);
            double[] expected = Arrays.stream(inputs).map(StrictMath::tanh).toArray();
            assertThat(Arrays.copyOfRange(senses.activations(), left * size, (left + 1) * size))
                    .containsExactly(expected);
        }
    }

    /** Each group of sensors is sensed in both ways, whatever other groups there are. */
    @Test
    void activations_areTheTangentsOfTheInputs_withEveryChoiceOfGroups() {
        SensorGroup[] groups = SensorGroup.values();
        Game game = new Game(0, GameRules.blended());
        int left = MOVE.LEFT.ordinal();
        for (int choice = 0; choice < 1 << groups.length; choice++) {
            Set<SensorGroup> chosen = EnumSet.noneOf(SensorGroup.class);
            for (SensorGroup group : groups) {
                if ((choice >> group.ordinal() & 1) != 0) {
                    chosen.add(group);
                }
            }
            SensorSuite suite = SensorSuite.of(new SensorSettings(chosen, 1, 30, 200, 10, List.of()));
            NetworkInputs senses = suite.newInputs();
            senses.observe(game);
            senses.sense(left);
            double[] activations =
                    Arrays.copyOfRange(senses.activations(), left * suite.size(), (left + 1) * suite.size());

            assertThat(activations)
                    .as("groups %s", chosen)
                    .containsExactly(Arrays.stream(senses.inputs(left))
                            .map(StrictMath::tanh)
                            .toArray());
        }
    }

    @Test
    void nthNearestJunction_isNeverNearerThanTheOneBefore_andTheFirstIsTheNearest() {
        SensorSuite suite = SensorSuite.of(everything(List.of()));
        NetworkInputs senses = suite.newInputs();
        senses.observe(new Game(0, GameRules.blended()));
        Observation observation = senses.observation();
        observation.face(MOVE.LEFT.ordinal());

        assertThat(observation.nthNearestJunction(0)).isEqualTo(observation.nearestJunction());
        for (int n = 1; n < 38; n++) {
            assertThat(observation.nthNearestJunction(n)).isGreaterThanOrEqualTo(observation.nthNearestJunction(n - 1));
        }
        assertThat(observation.nthNearestJunction(38)).isEqualTo(-1);
    }

    @Test
    void settings_nameParameterValueAndRange() {
        assertThatThrownBy(() -> new SensorSettings(EnumSet.noneOf(SensorGroup.class), 1, 100, 200, 10, List.of()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("smallStepSimDepth must be from 1 to 60, is 100");
    }
}
