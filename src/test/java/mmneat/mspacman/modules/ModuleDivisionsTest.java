package mmneat.mspacman.modules;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.zip.GZIPInputStream;
import mmneat.GoldenData;
import mmneat.mspacman.sensors.Observation;
import mmneat.mspacman.sensors.SensorSettings;
import mmneat.mspacman.sensors.suite.NetworkInputs;
import mmneat.mspacman.sensors.suite.SensorSuite;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import pacman.game.Game;
import pacman.game.GameRules;

class ModuleDivisionsTest {

    /** A division as a user would write it. */
    public static final class LevelParity implements ModuleDivision {
        @Override
        public int modules() {
            return 2;
        }

        @Override
        public int module(Observation observation) {
            return observation.game().getCurrentLevel() % 2;
        }
    }

    @Tag("conformance")
    @ParameterizedTest
    @ValueSource(strings = {"blended", "interleaved", "isolated"})
    void divisions_nameTheOriginalsModule_inEveryRecordedState(String version) throws IOException {
        Path file = GoldenData.folder("sensors").resolve(version + ".jsonl.gz");
        ObjectMapper json = new ObjectMapper();
        NetworkInputs senses = SensorSuite.of(SensorSettings.imprisoned()).newInputs();
        try (BufferedReader lines = new BufferedReader(
                new InputStreamReader(new GZIPInputStream(Files.newInputStream(file)), StandardCharsets.UTF_8))) {
            lines.readLine();
            int states = 0;
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                JsonNode state = json.readTree(line);
                Game game = new Game(0, GameRules.blended());
                game.setGameState(state.get("state").asText());
                senses.observe(game);
                for (Map.Entry<String, JsonNode> mode : state.get("modes").properties()) {
                    assertThat(ModuleDivisions.named(mode.getKey()).module(senses.observation()))
                            .as("%s %s", state.get("id").asText(), mode.getKey())
                            .isEqualTo(mode.getValue().asInt());
                }
                states++;
            }
            assertThat(states).isGreaterThan(800);
        }
    }

    @Test
    void named_findsTheOriginalsClassNames_andUserClasses() {
        assertThat(ModuleDivisions.named("edu.utexas.cs.nn.tasks.mspacman.multitask.AnyGhostEdibleModeSelector"))
                .isEqualTo(new AnyGhostEdible());
        assertThat(ModuleDivisions.named("AnyPills")).isEqualTo(new AnyPills());
        assertThat(ModuleDivisions.named(LevelParity.class.getName())).isInstanceOf(LevelParity.class);
    }

    @Test
    void named_listsKnownNames_forAnUnknownName() {
        assertThatThrownBy(() -> ModuleDivisions.named("AnyGhostEdibl"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("AnyGhostEdibl is neither")
                .hasMessageContaining("GhostThreatEdibleOrBothModeSelector");
    }
}
