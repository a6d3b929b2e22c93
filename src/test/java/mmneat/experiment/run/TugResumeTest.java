package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Stream;
import mmneat.GoldenData;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Runs with TUG that were interrupted and continued write the files of uninterrupted ones. */
@Tag("conformance")
class TugResumeTest {

    private static final int GENERATIONS = 9;

    @TempDir
    Path base;

    private static GoldenRun golden(String name) {
        return new GoldenRun(GoldenData.folder("runs-options").resolve(name));
    }

    private static List<String> words(GoldenRun golden, Path base, int generations) throws Exception {
        return golden.commandLine(base)
                .map(word -> word.startsWith("maxGens:") ? "maxGens:" + generations : word)
                .toList();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "TUG-adaptive",
                "TUG-dropping",
                "TUG-keepsFront",
                "TUG-previousGoals",
                "TUG-smallSteps",
                "TUG-thrashing",
                "TUG-window"
            })
    void runStoppedAfterEachGeneration_writesTheOriginalsFiles(String name) throws Exception {
        GoldenRun golden = golden(name);
        for (int generations = 1; generations <= GENERATIONS; generations++) {
            GoldenRun.run(words(golden, base, generations).stream());
        }
        golden.requireSameFiles(base);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 6, 8})
    void runStoppedOnce_writesTheOriginalsFiles(int generations) throws Exception {
        GoldenRun golden = golden("TUG-dropping");
        GoldenRun.run(words(golden, base, generations).stream());
        GoldenRun.run(golden.commandLine(base));
        golden.requireSameFiles(base);
    }

    @Test
    void runHaltedAtAnyMoment_writesTheOriginalsFiles() throws Exception {
        GoldenRun golden = golden("TUG-thrashing");
        List<String> words = words(golden, base, GENERATIONS);
        ParameterReader reader = new ParameterReader(ParameterCatalogue.load());
        ExecutorService other = Executors.newSingleThreadExecutor();
        boolean complete = false;
        for (int session = 0; session < 100 && !complete; session++) {
            ExperimentRunner experiment =
                    new ExperimentRunner(ExperimentPlan.of(reader.read(words).parameters()));
            Future<List<RunOutcome>> running = other.submit(experiment::run);
            long end = System.nanoTime() + session * session * 4_000_000L;
            while (System.nanoTime() < end) {
                Thread.onSpinWait();
            }
            assertThat(experiment.halt(Duration.ofMinutes(1))).isTrue();
            complete = Stream.of(running.get().get(0)).allMatch(RunOutcome::isComplete);
        }
        other.shutdown();
        assertThat(complete).isTrue();
        golden.requireSameFiles(base);
    }
}
