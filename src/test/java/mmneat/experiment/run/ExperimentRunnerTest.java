package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Stream;
import mmneat.evolution.Evaluation;
import mmneat.evolution.SmallTask;
import mmneat.evolution.XorTask;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.store.Checkpoint;
import mmneat.experiment.store.RunLock;
import mmneat.experiment.store.RunView;
import mmneat.experiment.store.SavedCheckpoint;
import mmneat.experiment.store.UnsyncedFiles;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whole experiments with a user's small task. */
class ExperimentRunnerTest {

    @TempDir
    Path folder;

    private final ParameterReader reader = new ParameterReader(ParameterCatalogue.load());

    private ExperimentPlan plan(String base, String... words) {
        List<String> all = new ArrayList<>(
                List.of("task=" + XorTask.class.getName(), "mating=true", "mu=6", "base=" + folder.resolve(base)));
        all.addAll(Arrays.asList(words));
        return ExperimentPlan.of(reader.read(all).parameters());
    }

    private List<RunOutcome> run(String base, String... words) throws InterruptedException {
        return new ExperimentRunner(plan(base, words)).run();
    }

    /** Returns the content of a run's files, except those with times or paths. */
    static Map<String, String> content(Path run) throws IOException {
        Map<String, String> content = new TreeMap<>();
        try (Stream<Path> files = Files.walk(run)) {
            for (Path file : (Iterable<Path>) files.filter(Files::isRegularFile)::iterator) {
                String name = run.relativize(file).toString();
                boolean holdsTimes = name.endsWith("_Performance_log.txt")
                        || name.startsWith("checkpoint")
                        || name.equals("status.json");
                if (!holdsTimes && !name.equals("parameters.properties")) {
                    content.put(name, Files.readString(file));
                }
            }
        }
        return content;
    }

    @Test
    void parallelRuns_equalSingleRuns() throws Exception {
        List<RunOutcome> together = run("together", "runs=4", "maxGens=4", "threads=3", "method=MMD");
        assertThat(together).allMatch(RunOutcome::isComplete);
        run("alone", "run=2", "maxGens=4", "method=MMD");
        assertThat(content(folder.resolve("together/MMD2")))
                .isEqualTo(content(folder.resolve("alone/MMD2")))
                .containsKeys("generations.csv", "champion.json", "XorTask-MMD2_parents_gen4.txt", "archetype0.xml");
        assertThat(content(folder.resolve("together/MMD1")).get("generations.csv"))
                .isNotEqualTo(content(folder.resolve("together/MMD2")).get("generations.csv"));
    }

    @Test
    void finishedRuns_areSkipped_unfinishedOnesContinued() throws Exception {
        run("half", "run=1", "maxGens=3");
        Instant before = Files.getLastModifiedTime(folder.resolve("half/1M1/generations.csv"))
                .toInstant();
        assertThat(run("half", "runs=3", "maxGens=3"))
                .extracting(RunOutcome::phase)
                .containsExactly(
                        RunMonitor.Phase.FINISHED, RunMonitor.Phase.ALREADY_FINISHED, RunMonitor.Phase.FINISHED);
        assertThat(Files.getLastModifiedTime(folder.resolve("half/1M1/generations.csv"))
                        .toInstant())
                .isEqualTo(before);
    }

    @Test
    void runContinuedWithMoreGenerations_equalsALongerRun() throws Exception {
        run("longer", "maxGens=2");
        run("longer", "maxGens=5");
        run("atOnce", "maxGens=5");
        assertThat(content(folder.resolve("longer/1M0"))).isEqualTo(content(folder.resolve("atOnce/1M0")));
    }

    @Test
    void otherParameters_inAStartedFolder_areAnError_andNoFileChanges() throws Exception {
        run("base", "maxGens=2");
        Map<String, String> before = content(folder.resolve("base/1M0"));
        assertThatThrownBy(() -> run("base", "maxGens=3", "crossoverRate=0.3", "runs=2"))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("begun with crossoverRate=0.5 (now 0.3)");
        assertThat(content(folder.resolve("base/1M0"))).isEqualTo(before);
        assertThat(folder.resolve("base/1M1")).doesNotExist();
        assertThatThrownBy(() -> run("base", "maxGens=3", "task.noise=0.3"))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("begun with no task.noise (now 0.3); give the same");
        run("noisy", "maxGens=2", "task.noise=0.3");
        Path parameters = folder.resolve("noisy/1M0/parameters.properties");
        String saved = Files.readString(parameters);
        assertThatThrownBy(() -> run("noisy", "maxGens=3"))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("begun with task.noise=0.3 (now not given); give the same");
        assertThat(parameters).hasContent(saved);
    }

    @Test
    void parametersOfAnOlderProgram_mayLackNamesOfTheCatalogue() throws Exception {
        run("older", "maxGens=2");
        Path parameters = folder.resolve("older/1M0/parameters.properties");
        List<String> lines = Files.readAllLines(parameters);
        assertThat(lines.removeIf(line -> line.startsWith("crowding="))).isTrue();
        Files.write(parameters, lines);
        assertThat(run("older", "maxGens=3")).allMatch(RunOutcome::isComplete);
    }

    @Test
    void parallelEvaluations_giveTheSameForAnyNumberOfThreads() throws Exception {
        run("one", "parallelEvaluations=true", "threads=1", "maxGens=3");
        run("three", "parallelEvaluations=true", "threads=3", "maxGens=3");
        run("exact", "maxGens=3");
        assertThat(content(folder.resolve("one/1M0"))).isEqualTo(content(folder.resolve("three/1M0")));
        assertThat(content(folder.resolve("one/1M0")).get("generations.csv"))
                .isNotEqualTo(content(folder.resolve("exact/1M0")).get("generations.csv"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"auto", "1", "5"})
    void runHaltedAtAnyMoment_andContinued_equalsAnUninterruptedOne(String checkpointEvery) throws Exception {
        run("whole", "maxGens=12", "method=MMD", "checkpointEvery=1");
        ExecutorService other = Executors.newSingleThreadExecutor();
        int halted = 0;
        boolean complete = false;
        for (int session = 0; session < 100 && !complete; session++) {
            ExperimentRunner experiment = new ExperimentRunner(
                    plan("halted", "maxGens=12", "method=MMD", "checkpointEvery=" + checkpointEvery));
            Future<List<RunOutcome>> running = other.submit(experiment::run);
            // Each session is stopped slightly later. The next session must continue from any point.
            long end = System.nanoTime() + session * session * 2_000_000L;
            while (System.nanoTime() < end) {
                Thread.onSpinWait();
            }
            assertThat(experiment.halt(Duration.ofMinutes(1))).isTrue();
            RunOutcome outcome = running.get().get(0);
            halted += outcome.phase() == RunMonitor.Phase.STOPPED ? 1 : 0;
            complete = outcome.isComplete();
            assertThat(folder.resolve("halted/MMD0/lock.json")).doesNotExist();
        }
        other.shutdown();
        assertThat(complete).isTrue();
        assertThat(halted).isGreaterThan(1);
        assertThat(content(folder.resolve("halted/MMD0"))).isEqualTo(content(folder.resolve("whole/MMD0")));
    }

    @Test
    void unsyncedFilesLostByAFailingMachine_areMadeAgain_theSame() throws Exception {
        run("whole", "maxGens=30", "method=MMD");
        ExperimentRunner experiment =
                new ExperimentRunner(plan("stopped", "maxGens=30", "method=MMD", "checkpointEvery=1"));
        ExecutorService other = Executors.newSingleThreadExecutor();
        Future<List<RunOutcome>> running = other.submit(experiment::run);
        while (experiment.monitors().get(0).snapshot().generation() < 4) {
            Thread.onSpinWait();
        }
        assertThat(experiment.halt(Duration.ofMinutes(1))).isTrue();
        assertThat(running.get().get(0).phase()).isEqualTo(RunMonitor.Phase.STOPPED);
        other.shutdown();

        Path stopped = folder.resolve("stopped/MMD0");
        Checkpoint checkpoint = SavedCheckpoint.newest(stopped);
        List<String> files = new ArrayList<>(checkpoint.unsynced().keySet());
        assertThat(files)
                .contains(
                        "generations.csv",
                        "XorTask-MMD0_parents_gen2.txt",
                        "XorTask-MMD0_Lineage_log.txt",
                        "bestPacMan/bestPacMan.xml")
                .doesNotContain("XorTask-MMD0_parents_gen0.txt");
        files.addAll(List.of("archetype0.xml", "gen1/XorTask-MMD0_gen1_3.xml", "checkpoint.json.gz", "status.json"));
        for (int loss = 0; loss < 3; loss++) {
            Path damaged = folder.resolve("damaged" + loss + "/MMD0");
            copy(stopped, damaged);
            for (String file : files) {
                // A failure loses the part of a log that was appended since the last sync.
                UnsyncedFiles.Stretch stretch = checkpoint.unsynced().get(file);
                int synced = stretch == null ? 0 : (int) stretch.from();
                byte[] left = losses(Files.readAllBytes(stopped.resolve(file)), synced)
                        .get(loss);
                Files.write(damaged.resolve(file), left);
            }
            run("damaged" + loss, "maxGens=30", "method=MMD");
            assertThat(content(damaged)).as("loss %d", loss).isEqualTo(content(folder.resolve("whole/MMD0")));
        }
    }

    /**
     * Returns what a failure may leave of a file: without the unsynced part, with half of it, or with zeros instead of
     * it.
     */
    private static List<byte[]> losses(byte[] content, int synced) {
        byte[] zeros = Arrays.copyOf(Arrays.copyOf(content, synced), content.length);
        return List.of(Arrays.copyOf(content, synced), Arrays.copyOf(content, (synced + content.length) / 2), zeros);
    }

    private static void copy(Path from, Path to) throws IOException {
        try (Stream<Path> files = Files.walk(from)) {
            for (Path file : (Iterable<Path>) files::iterator) {
                Path copied = to.resolve(from.relativize(file).toString());
                Files.createDirectories(copied.getParent());
                Files.copy(file, copied);
            }
        }
    }

    @Test
    void movedFolder_isContinuedWhereItIs() throws Exception {
        run("whole", "maxGens=6");
        run("here", "maxGens=3");
        Files.createDirectories(folder.resolve("there/below"));
        Files.move(folder.resolve("here/1M0"), folder.resolve("there/below/1M0"));
        run("there/below", "maxGens=6");
        assertThat(content(folder.resolve("there/below/1M0"))).isEqualTo(content(folder.resolve("whole/1M0")));
    }

    @Test
    void damagedCheckpoint_thePreviousOneIsUsed_andTheResultIsTheSame() throws Exception {
        run("whole", "maxGens=6");
        run("damaged", "maxGens=4");
        Files.write(folder.resolve("damaged/1M0/checkpoint.json.gz"), new byte[] {1, 2, 3});
        assertThat(run("damaged", "maxGens=6")).allMatch(RunOutcome::isComplete);
        assertThat(content(folder.resolve("damaged/1M0"))).isEqualTo(content(folder.resolve("whole/1M0")));
    }

    @Test
    void tableOfGenerations_countsTheStepsOfParentsAndChildren() throws Exception {
        run("steps", "mu=5", "maxGens=2");
        // An evaluation has 20 steps.
        assertThat(Files.readAllLines(folder.resolve("steps/1M0/generations.csv")).stream()
                        .map(line -> line.split(",")[8]))
                .containsExactly("steps", "200", "200", "100");
    }

    @Test
    void runLockedByAnotherProcess_isSkipped_andTheOthersAreCompleted() throws Exception {
        Files.createDirectories(folder.resolve("held/1M0"));
        try (RunLock lock = RunLock.acquire(folder.resolve("held/1M0"), RunLock.Timing.USUAL)) {
            List<RunOutcome> outcomes = run("held", "runs=2", "maxGens=2");
            assertThat(outcomes)
                    .extracting(RunOutcome::phase)
                    .containsExactly(RunMonitor.Phase.IN_USE, RunMonitor.Phase.FINISHED);
            assertThat(outcomes.get(0).message()).contains("in use by process");
            assertThat(folder.resolve("held/1M0").toFile().list()).containsExactly("lock.json");
            lock.requireHeld();
        }
    }

    @Test
    void status_fromTheFilesAlone_showsFinishedAndWaitingRuns() throws Exception {
        run("seen", "runs=2", "maxGens=2");
        ExperimentView.recordRequested(plan("seen", "runs=4", "maxGens=2"));
        List<ExperimentView> experiments = ExperimentView.readAll(folder, Instant.now());
        assertThat(experiments).hasSize(1);
        ExperimentView seen = experiments.get(0);
        assertThat(seen.name()).isEqualTo("XorTask-1M");
        assertThat(seen.runs())
                .extracting(RunView::state)
                .containsExactly(
                        RunView.State.FINISHED, RunView.State.FINISHED, RunView.State.WAITING, RunView.State.WAITING);
        assertThat(seen.isFinished()).isFalse();
        assertThat(seen.best()).isPresent();
    }

    /** A task that fails in the second generation. */
    public static final class BreakingTask extends SmallTask {
        private int evaluations;

        @Override
        public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
            if (++evaluations > 20) {
                throw new IllegalStateException("broken");
            }
            return new Evaluation(
                    new double[] {random.nextDouble()},
                    new double[0],
                    new int[genotype.modules()],
                    Evaluation.Outcomes.NONE);
        }
    }

    @Test
    void taskThatThrows_isAFailureWithItsStackTrace_andTheLastGenerationIsKept() throws Exception {
        RunOutcome outcome = new ExperimentRunner(ExperimentPlan.of(reader.read(List.of(
                                "task=" + BreakingTask.class.getName(),
                                "mu=6",
                                "maxGens=5",
                                "base=" + folder.resolve("broken")))
                        .parameters()))
                .run()
                .get(0);
        assertThat(outcome.phase()).isEqualTo(RunMonitor.Phase.FAILED);
        assertThat(outcome.failure()).hasMessage("broken");
        RunView view = RunView.read(outcome.run().directory(), Instant.now());
        assertThat(view.state()).isEqualTo(RunView.State.FAILED);
        assertThat(view.status().generation()).isEqualTo(1);
        assertThat(SavedCheckpoint.newest(outcome.run().directory())).isNotNull();
    }
}
