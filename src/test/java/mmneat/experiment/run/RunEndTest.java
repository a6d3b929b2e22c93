package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import mmneat.evolution.Evaluation;
import mmneat.evolution.SmallTask;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.store.Checkpoint;
import mmneat.experiment.store.RunStatus;
import mmneat.experiment.store.SavedCheckpoint;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Runs that fail, are interrupted, or have impossible parameters. */
class RunEndTest {

    private static final int MU = 3;

    /** The action of an evaluation, by its number in this process, and of a call for a champion's score. */
    private static volatile Evaluating evaluating;

    private static volatile Runnable scoring;

    /** The number of the evaluation that returns NaN. */
    private static volatile int withoutScore;

    @TempDir
    Path folder;

    private interface Evaluating {
        void begin(int evaluation);
    }

    /** A task whose evaluations perform the actions of a test. */
    public static final class EventfulTask extends SmallTask {
        private int evaluations;

        @Override
        public double championScore(Evaluation evaluation) {
            scoring.run();
            return evaluation.objectives()[0];
        }

        @Override
        public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
            double score = evaluations == withoutScore ? Double.NaN : random.nextDouble();
            evaluating.begin(evaluations++);
            return new Evaluation(
                    new double[] {score}, new double[0], new int[genotype.modules()], Evaluation.Outcomes.NONE);
        }
    }

    @AfterEach
    void nothingHappensAnyMore() {
        uneventful();
    }

    private static void uneventful() {
        evaluating = evaluation -> {};
        scoring = () -> {};
        withoutScore = -1;
    }

    RunEndTest() {
        uneventful();
    }

    private ExperimentRunner experiment(String... words) {
        List<String> all = new ArrayList<>(
                List.of("task=" + EventfulTask.class.getName(), "checkpointEvery=1", "mu=" + MU, "base=" + folder));
        all.addAll(Arrays.asList(words));
        return new ExperimentRunner(ExperimentPlan.of(
                new ParameterReader(ParameterCatalogue.load()).read(all).parameters()));
    }

    private RunOutcome run(String... words) throws InterruptedException {
        return experiment(words).run().get(0);
    }

    private Path file(String name) {
        return folder.resolve("1M0").resolve(name);
    }

    private RunStatus status() throws IOException {
        return RunStatus.read(folder.resolve("1M0")).orElseThrow();
    }

    /** Makes evaluations fail after this number of complete generations. */
    private static void failAfter(int generations) {
        evaluating = evaluation -> {
            if (evaluation >= 2 * MU * generations) {
                throw new IllegalStateException("broken");
            }
        };
    }

    @Test
    void runWithoutAnIntactCheckpoint_isRefused_andNoFileChanges() throws Exception {
        run("maxGens=4");
        RunStatus before = status();
        Files.writeString(file("checkpoint.json.gz"), "x");
        Files.writeString(file("checkpoint-previous.json.gz"), "y");
        RunOutcome outcome = run("maxGens=6");
        assertThat(outcome.phase()).isEqualTo(RunMonitor.Phase.REFUSED);
        assertThat(outcome.message()).contains("no undamaged checkpoint");
        assertThat(status()).isEqualTo(before);
    }

    @Test
    void failureWithoutTheLock_doesNotChangeTheStatus() throws Exception {
        run("maxGens=2");
        String before = Files.readString(file("status.json"));
        // A lock can neither be created nor read here.
        Files.createDirectory(file("lock.json"));
        RunOutcome outcome = run("maxGens=3");
        assertThat(outcome.phase()).isEqualTo(RunMonitor.Phase.FAILED);
        assertThat(outcome.message()).startsWith("cannot write or read in ");
        assertThat(file("status.json")).hasContent(before);
    }

    @Test
    void failureAfterTheLockWasLost_doesNotChangeTheStatus() throws Exception {
        evaluating = evaluation -> {
            if (evaluation >= 2 * MU) {
                try {
                    Files.writeString(file("status.json"), "another's");
                    Files.delete(file("lock.json"));
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
                throw new IllegalStateException("broken");
            }
        };
        RunOutcome outcome = run("maxGens=3");
        assertThat(outcome.phase()).isEqualTo(RunMonitor.Phase.FAILED);
        assertThat(outcome.failure()).hasMessage("broken");
        assertThat(file("status.json")).hasContent("another's");
    }

    @Test
    void generationAfterTheLockWasLost_isNotWritten() throws Exception {
        evaluating = evaluation -> {
            if (evaluation == 2 * MU) {
                try {
                    Files.delete(file("lock.json"));
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            }
        };
        RunOutcome outcome = run("maxGens=5");
        assertThat(outcome.phase()).isEqualTo(RunMonitor.Phase.IN_USE);
        assertThat(outcome.message()).contains("lock.json was deleted");
        assertThat(status().generation()).isEqualTo(1);
        assertThat(file("RunEndTest$EventfulTask-1M0_parents_gen1.txt")).doesNotExist();
    }

    @Test
    void continuedRun_hasTheNetworksOfItsCheckpoint_andASyncedCheckpoint() throws Exception {
        failAfter(3);
        run("maxGens=5");
        assertThat(file("gen3")).doesNotExist();
        assertThat(checkpoint().wasSynced()).isFalse();
        failAfter(0);
        run("maxGens=5");
        assertThat(file("gen3").toFile().list()).hasSize(MU);
        assertThat(file("gen1")).doesNotExist();
        assertThat(checkpoint().wasSynced()).isTrue();
        assertThat(checkpoint().evolution().generation()).isEqualTo(3);
    }

    private Checkpoint checkpoint() throws IOException {
        return SavedCheckpoint.newest(folder.resolve("1M0"));
    }

    @Test
    void nanScoreOfTheFinalParents_isAFailureThatNamesIt_andTheRunIsNotFinished() throws Exception {
        withoutScore = 2 * MU * 2 + 1;
        RunOutcome outcome = run("maxGens=2");
        assertThat(outcome.phase()).isEqualTo(RunMonitor.Phase.FAILED);
        assertThat(outcome.message())
                .startsWith("task=" + EventfulTask.class.getName() + ": genotype ")
                .endsWith(
                        " in generation 2: the task gave NaN for the objective 'Score', which must be a finite number");
        assertThat(outcome.failure()).isNull();
        assertThat(status().isFinished(2)).isFalse();
    }

    @Test
    void fewerGenerationsThanAreComplete_areAnError_andNoFileChanges() throws Exception {
        failAfter(3);
        assertThat(run("maxGens=5").phase()).isEqualTo(RunMonitor.Phase.FAILED);
        uneventful();
        String before = Files.readString(file("parameters.properties"));
        String message = folder.resolve("1M0") + " has completed 3 generations, more than maxGens=2; give maxGens=3 or"
                + " more to continue it, or another folder with base=FOLDER";
        assertThatThrownBy(() -> run("maxGens=2")).isInstanceOf(UserError.class).hasMessage(message);
        Files.delete(file("status.json"));
        RunOutcome withoutStatus = run("maxGens=2");
        assertThat(withoutStatus.phase()).isEqualTo(RunMonitor.Phase.REFUSED);
        assertThat(withoutStatus.message()).isEqualTo(message);
        assertThat(file("parameters.properties")).hasContent(before);
        assertThat(run("maxGens=3").phase()).isEqualTo(RunMonitor.Phase.FINISHED);
    }

    @Test
    void interruptedExperiment_returnsWhenItsRunsHaveEnded() throws Exception {
        CountDownLatch begun = new CountDownLatch(1);
        evaluating = evaluation -> {
            begun.countDown();
            while (!Thread.currentThread().isInterrupted()) {
                Thread.onSpinWait();
            }
            // An evaluation may react to an interruption late.
            long end = System.nanoTime() + 300_000_000L;
            while (System.nanoTime() < end) {
                Thread.onSpinWait();
            }
        };
        ExperimentRunner experiment = experiment("maxGens=2");
        ExecutorService other = Executors.newSingleThreadExecutor();
        Future<Boolean> leftLocked = other.submit(() -> {
            try {
                experiment.run();
                throw new IllegalStateException("not interrupted");
            } catch (InterruptedException e) {
                return Files.exists(file("lock.json"));
            }
        });
        begun.await();
        other.shutdownNow();
        assertThat(leftLocked.get()).isFalse();
        assertThat(experiment.monitors().get(0).snapshot().phase()).isEqualTo(RunMonitor.Phase.STOPPED);
    }

    @Test
    void interruptionDuringWriting_stopsTheRun_whichCanBeContinued() throws Exception {
        // Called in each generation when its row is written.
        scoring = () -> Thread.currentThread().interrupt();
        RunOutcome stopped = run("maxGens=3");
        assertThat(stopped.phase()).isEqualTo(RunMonitor.Phase.STOPPED);
        assertThat(stopped.message()).isEqualTo("stopped");
        assertThat(status().state()).isEqualTo(RunStatus.State.RUNNING);
        assertThat(file("lock.json")).doesNotExist();
        uneventful();
        assertThat(run("maxGens=3").phase()).isEqualTo(RunMonitor.Phase.FINISHED);
    }
}
