package pacman.game;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIfSystemProperty;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;

/**
 * Games recorded by an engine that had passed the original's traces. They check the rules where those traces are not
 * available.
 *
 * <p>To record them again after an intended change of the rules: {@code mvn test -Dtest=RecordedGamesTest
 * -Drecord=true}. The format is that of the traces: one JSON array per step, and lines for rules, games, whole states,
 * side branches and ends; {@link TracedGame} describes the fields.
 */
class RecordedGamesTest {

    private static final Path FILE = Path.of("src/test/resources/pacman/game/recorded-games.jsonl.gz");

    @Test
    @EnabledIfSystemProperty(named = "record", matches = "true")
    void record() throws IOException {
        Files.createDirectories(FILE.getParent());
        try (Writer out =
                new OutputStreamWriter(new GZIPOutputStream(Files.newOutputStream(FILE)), StandardCharsets.UTF_8)) {
            new GameRecorder(line -> {
                        try {
                            out.write(line + "\n");
                        } catch (IOException e) {
                            throw new UncheckedIOException(e);
                        }
                    })
                    .record();
        }
        assertThat(Files.size(FILE)).isPositive();
    }

    @Test
    @DisabledIfSystemProperty(named = "record", matches = "true")
    void recordedGames_replayStepByStep() throws IOException {
        TraceReplay replay = new TraceReplay("recorded-games", GameRecorder.ghostLocations());
        try (InputStream in = RecordedGamesTest.class.getResourceAsStream("recorded-games.jsonl.gz")) {
            replay.replay(in);
        }
        assertThat(replay.games).isEqualTo(45);
        assertThat(replay.steps).isGreaterThan(10_000);
        assertThat(replay.probes).isGreaterThan(100);
    }
}
