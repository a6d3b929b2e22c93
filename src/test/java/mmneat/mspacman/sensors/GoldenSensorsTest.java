package mmneat.mspacman.sensors;

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
import java.util.List;
import java.util.zip.GZIPInputStream;
import mmneat.GoldenData;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import pacman.game.Constants.MOVE;
import pacman.game.internal.Mazes;

/** Every sensor value that the original recorded, to the last bit. */
@Tag("conformance")
class GoldenSensorsTest {

    @ParameterizedTest
    @ValueSource(strings = {"blended", "interleaved", "isolated"})
    void sensors_equalTheOriginals_inEveryRecordedState(String version) throws IOException {
        Path file = GoldenData.folder("sensors").resolve(version + ".jsonl.gz");
        SensorSuite suite =
                SensorSuite.of(version.equals("blended") ? SensorSettings.blended() : SensorSettings.imprisoned());
        Senses senses = suite.newSenses();
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
            assertThat(vectors).isGreaterThan(1800);
        }
    }

    private static int compare(SensorSuite suite, Senses senses, JsonNode state) {
        String[] fields = state.get("state").asText().split(",");
        Situation situation = senses.situation();
        situation.enter(suite.tables(Mazes.standard().get(Integer.parseInt(fields[20]))));
        situation.placePacMan(Integer.parseInt(fields[26]));
        for (int ghost = 0; ghost < 4; ghost++) {
            situation.placeGhost(
                    ghost,
                    Integer.parseInt(fields[30 + 4 * ghost]),
                    Integer.parseInt(fields[31 + 4 * ghost]),
                    Integer.parseInt(fields[32 + 4 * ghost]),
                    MOVE.valueOf(fields[33 + 4 * ghost]).ordinal());
        }
        String pills = fields[46];
        for (int word = 0; 64 * word < pills.length(); word++) {
            situation.setPills(word, bits(pills, 64 * word));
        }
        situation.setPowerPills(bits(fields[47], 0));
        situation.conclude();
        senses.senseCommon();
        int vectors = 0;
        for (MOVE move : List.of(MOVE.UP, MOVE.RIGHT, MOVE.DOWN, MOVE.LEFT)) {
            JsonNode expected = state.get("inputs").get(move.name());
            assertThat(situation.isOpen(move.ordinal())).isEqualTo(expected != null);
            if (expected != null) {
                vectors++;
                double[] inputs = senses.inputs(move.ordinal());
                double[] activations = senses.activations(move.ordinal());
                for (int i = 0; i < inputs.length; i++) {
                    assertThat(inputs[i])
                            .as("%s %s: %s", state.get("id").asText(), move, suite.labels(move.ordinal()).get(i))
                            .isEqualTo(expected.get(i).asDouble());
                    assertThat(activations[i]).isEqualTo(StrictMath.tanh(inputs[i]));
                }
            }
        }
        return vectors;
    }

    private static long bits(String digits, int from) {
        long bits = 0;
        for (int i = from; i < Math.min(digits.length(), from + 64); i++) {
            bits |= (long) (digits.charAt(i) - '0') << i;
        }
        return bits;
    }
}
