package pacman.game;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import mmneat.GoldenData;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Games of the original, step by step: every value of every line, by checksums of lines in the compact data. */
@Tag("conformance")
class TraceConformanceTest {

    @ParameterizedTest
    @CsvSource({
        "competition, 101, 128326",
        "threelives, 17, 36151",
        "blended, 163, 65016",
        "interleaved, 103, 50703",
        "pilltask, 95, 27456",
        "ghosttask, 80, 51238",
        "weird, 255, 49100",
        "long, 5, 58536",
        "extras, 65, 32915"
    })
    void games_equalTheOriginals_stepByStep(String file, int games, int steps) throws IOException {
        Path traces = GoldenData.folder("traces");
        TraceReplay replay = new TraceReplay(file, originalGhostLocations());
        try (InputStream in = Files.newInputStream(traces.resolve(file + ".jsonl.gz"))) {
            replay.replay(in);
        }
        if (GoldenData.isFull() || !file.equals("ghosttask")) {
            assertThat(replay.games).isEqualTo(games);
            assertThat(replay.steps).isEqualTo(steps);
        } else {
            // The compact data leave out games, and with them most of the ghost locations.
            assertThat(replay.games).isEqualTo(32);
            assertThat(replay.steps).isGreaterThan(15_000);
        }
    }

    static GhostLocations originalGhostLocations() throws IOException {
        Path file = GoldenData.folder("ghost-locations").resolve("PowerPillToGhostLocationMapping.txt");
        try (Reader text = Files.newBufferedReader(file)) {
            return GhostLocations.read(file.getFileName().toString(), text);
        }
    }
}
