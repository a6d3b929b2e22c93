package pacman.game;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.zip.GZIPInputStream;

/**
 * Replays a trace file, full or compact ({@link CompactTraces}), from its recorded inputs, and compares every line with
 * the engine's.
 */
final class TraceReplay {

    private final String name;
    private final GhostLocations ghostLocations;
    private GameRules rules;
    private TracedGame traced;
    private String game;
    private int step;
    private CompactTraces.Checksum checksum;

    int games;
    int steps;
    int probes;

    TraceReplay(String name, GhostLocations ghostLocations) {
        this.name = name;
        this.ghostLocations = ghostLocations;
    }

    void replay(InputStream gzip) throws IOException {
        try (BufferedReader lines = new BufferedReader(
                new InputStreamReader(new GZIPInputStream(gzip, 1 << 16), StandardCharsets.UTF_8), 1 << 16)) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                replay(line);
            }
        }
    }

    void replay(String line) throws IOException {
        switch (line.charAt(0)) {
            case '[' -> step(line);
            case '{' -> describe(TracedGame.JSON.readTree(line));
            case '#' ->
                assertThat(checksum.take())
                        .as("checksum of the steps up to " + where())
                        .isEqualTo(line);
            default -> {
                checksum.add(traced.step(line.charAt(0), line.substring(1)));
                step++;
                steps++;
            }
        }
    }

    private void step(String line) {
        // ["U","....",... or ["U","null",...
        int end = line.indexOf('"', 6);
        String actual = traced.step(line.charAt(2), line.substring(6, end));
        step++;
        steps++;
        if (!actual.equals(line)) {
            throw new AssertionError(where() + "\nexpected " + line + "\nbut was  " + actual);
        }
    }

    private String where() {
        return name + ", game " + game + ", step " + step;
    }

    private void describe(JsonNode line) {
        switch (line.get("type").asText()) {
            case "rules" -> rules = TraceRules.read(line, ghostLocations);
            case "game" -> begin(line);
            case "full" ->
                assertThat(traced.game.getGameState())
                        .as(where())
                        .isEqualTo(line.get("state").asText());
            case "probe" -> probe(line);
            case "end" -> end(line);
            default -> throw new AssertionError("unknown line in " + name + ": " + line);
        }
    }

    private void begin(JsonNode line) {
        game = line.get("id").asText();
        games++;
        step = 0;
        checksum = new CompactTraces.Checksum();
        GameRules own = rules.withMazes(
                mazes -> mazes.withInitialMaze(line.get("initialMaze").asInt())
                        .withStartingPowerPill(line.get("startPowerPill").asInt()));
        traced = new TracedGame(
                line.get("seed").asLong(), own, line.get("globalSeed").asLong());
        assertThat(traced.drawsAtStart())
                .as(where())
                .isEqualTo(line.get("globalDrawsAtStart").asLong());
        assertThat(traced.game.getGameState())
                .as(where())
                .isEqualTo(line.get("state").asText());
    }

    private void probe(JsonNode line) {
        probes++;
        JsonNode actual = traced.probe(
                line.get("kind").asText(),
                line.get("method").asText(),
                line.get("pac").asText(),
                line.get("ghosts").asText());
        // The original crashes when a restored game, which has no record of a power pill, counts an eaten ghost. We
        // play on.
        if (!line.has("throws")) {
            assertThat(actual).as(where()).isEqualTo(line);
        }
    }

    private void end(JsonNode line) {
        JsonNode actual = traced.end(step, line.get("levelScores").size());
        assertThat(actual.toString()).as(where()).isEqualTo(line.toString());
    }
}
