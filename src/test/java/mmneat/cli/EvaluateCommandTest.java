package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import mmneat.analysis.results.RunFixture;
import mmneat.neat.ModuleLayout;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class EvaluateCommandTest extends CommandTest {

    @TempDir
    Path base;

    @Test
    void championNamedTwice_playsOnce() throws IOException {
        Path run = RunFixture.run(base, "blended", "2M", 0, 1000, 2000);
        Path champion = RunFixture.champion(run, ModuleLayout.withPreferenceNeurons(2, 1), 1);
        int code = execute("evaluate", run.toString(), champion.toString(), "games=3");
        assertThat(errors.toString()).isEmpty();
        assertThat(code).isZero();
        assertThat(run.resolve("evaluation-training.csv")).content().hasLineCount(1 + 3);
    }
}
