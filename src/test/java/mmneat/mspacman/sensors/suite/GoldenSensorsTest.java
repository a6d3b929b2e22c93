package mmneat.mspacman.sensors.suite;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.zip.GZIPInputStream;
import mmneat.GoldenData;
import mmneat.mspacman.sensors.Sensor;
import mmneat.mspacman.sensors.SensorGroup;
import mmneat.mspacman.sensors.SensorSettings;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GameRules;

/** Every sensor value that the original recorded, to the last bit. */
@Tag("conformance")
class GoldenSensorsTest {

    @ParameterizedTest
    @ValueSource(strings = {"blended", "interleaved", "isolated"})
    void sensors_equalTheOriginals_inEveryRecordedState(String version) throws IOException {
        SensorSettings settings = version.equals("blended") ? SensorSettings.blended() : SensorSettings.imprisoned();
        int vectors = compareAll(GoldenData.folder("sensors").resolve(version + ".jsonl.gz"), settings);
        assertThat(vectors).isGreaterThan(1800);
    }

    @ParameterizedTest
    @ValueSource(strings = {"split", "split-and-order", "etime-specific", "all"})
    void sensorsOfOtherOptions_equalTheOriginals_inEveryRecordedState(String options) throws IOException {
        int vectors =
                compareAll(GoldenData.folder("sensors-options").resolve(options + ".jsonl.gz"), settings(options));
        assertThat(vectors).isEqualTo(696);
    }

    private static SensorSettings settings(String options) {
        SensorSettings split = SensorSettings.blended().with(SensorGroup.NEAREST_OF_EACH_KIND);
        return switch (options) {
            case "split" -> SensorSettings.split();
            case "split-and-order" -> split;
            case "etime-specific" -> timesOfNumberedGhosts(SensorSettings.blended());
            case "all" -> timesOfNumberedGhosts(split);
            default -> throw new IllegalArgumentException(options);
        };
    }

    private static SensorSettings timesOfNumberedGhosts(SensorSettings settings) {
        return settings.with(SensorGroup.TIME_VERSUS_DISTANCE).with(SensorGroup.NUMBERED_GHOSTS);
    }

    /** Compares a file of recorded states; returns the number of input vectors. */
    private static int compareAll(Path file, SensorSettings settings) throws IOException {
        SensorSuite suite = SensorSuite.of(settings);
        NetworkInputs senses = suite.newInputs();
        ObjectMapper json = new ObjectMapper();
        try (BufferedReader lines = new BufferedReader(
                new InputStreamReader(new GZIPInputStream(Files.newInputStream(file)), StandardCharsets.UTF_8))) {
            JsonNode header = json.readTree(lines.readLine());
            List<String> names = new ArrayList<>();
            header.get("names").forEach(name -> names.add(name.asText()));
            assertThat(suite.sensors()).extracting(Sensor::label).containsExactlyElementsOf(names);
            int vectors = 0;
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                vectors += compare(suite, senses, json.readTree(line));
            }
            return vectors;
        }
    }

    private static int compare(SensorSuite suite, NetworkInputs senses, JsonNode state) {
        Game game = new Game(0, GameRules.blended());
        game.setGameState(state.get("state").asText());
        senses.observe(game);
        int vectors = 0;
        for (MOVE move : List.of(MOVE.UP, MOVE.RIGHT, MOVE.DOWN, MOVE.LEFT)) {
            JsonNode expected = state.get("inputs").get(move.name());
            assertThat(senses.observation().isOpen(move.ordinal())).isEqualTo(expected != null);
            if (expected != null) {
                vectors++;
                double[] inputs = senses.inputs(move.ordinal()).clone();
                double[] recorded = new double[inputs.length];
                double[] tangents = new double[inputs.length];
                for (int i = 0; i < inputs.length; i++) {
                    recorded[i] = expected.get(i).asDouble();
                    tangents[i] = StrictMath.tanh(recorded[i]);
                }
                if (!Arrays.equals(inputs, recorded)) {
                    assertThat(inputs)
                            .as("%s %s: %s", state.get("id").asText(), move, suite.labels(move.ordinal()))
                            .containsExactly(recorded);
                }
                senses.sense(move.ordinal());
                int row = move.ordinal() * inputs.length;
                double[] activations = Arrays.copyOfRange(senses.activations(), row, row + inputs.length);
                if (!Arrays.equals(activations, tangents)) {
                    assertThat(activations).containsExactly(tangents);
                }
            }
        }
        return vectors;
    }
}
