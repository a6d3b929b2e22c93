package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import mmneat.evolution.Evaluation;
import mmneat.evolution.Task;
import mmneat.evolution.XorTask;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.store.RunStatus;
import mmneat.neat.Genotype;
import mmneat.neat.network.Network;
import mmneat.neat.network.NetworkState;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Runs of a deterministic task: kept scores, and the end at a given score. */
class KeptScoresTest {

    private static final AtomicInteger EVALUATIONS = new AtomicInteger();

    @TempDir
    Path folder;

    /** Exclusive or without noise. */
    public static final class ExactXor implements Task {
        @Override
        public List<String> objectiveNames() {
            return List.of("Correctness", "Sparseness");
        }

        @Override
        public List<String> inputLabels() {
            return List.of("Bias", "First", "Second");
        }

        @Override
        public int policyNeuronsPerModule() {
            return 1;
        }

        @Override
        public boolean isDeterministic() {
            return true;
        }

        @Override
        public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
            EVALUATIONS.incrementAndGet();
            NetworkState state = Network.compile(genotype).newState();
            int[] usage = new int[genotype.modules()];
            double error = 0;
            for (int bits = 0; bits < 4; bits++) {
                state.flush();
                usage[state.activate(new double[] {1, bits & 1, bits >> 1}, random)]++;
                error += Math.abs(state.policyOutput(0) - ((bits & 1) ^ (bits >> 1)));
            }
            return new Evaluation(
                    new double[] {1 - error / 4, -genotype.links().size()},
                    new double[0],
                    usage,
                    new Evaluation.Outcomes(0, 0, 0, 4));
        }
    }

    @BeforeEach
    void startCounting() {
        EVALUATIONS.set(0);
    }

    private List<RunOutcome> run(Class<?> task, String base, String... words) throws InterruptedException {
        List<String> all = new ArrayList<>(
                List.of("task=" + task.getName(), "mating=true", "mu=10", "base=" + folder.resolve(base)));
        all.addAll(Arrays.asList(words));
        ParameterReader reader = new ParameterReader(ParameterCatalogue.load());
        return new ExperimentRunner(ExperimentPlan.of(reader.read(all).parameters())).run();
    }

    @Test
    void keptScores_giveTheSameFiles_andSaveTheParentsEvaluations() throws Exception {
        run(ExactXor.class, "again", "maxGens=20", "method=2M");
        assertThat(EVALUATIONS.getAndSet(0)).isEqualTo(20 * 20 + 10);
        run(ExactXor.class, "kept", "maxGens=20", "method=2M", "keepScores=true");
        assertThat(EVALUATIONS.get()).isEqualTo(10 + 20 * 10);
        assertThat(ExperimentRunnerTest.content(folder.resolve("kept/2M0")))
                .isEqualTo(ExperimentRunnerTest.content(folder.resolve("again/2M0")));
    }

    @Test
    void keptScores_ofATaskThatDependsOnChance_areRefused() throws Exception {
        RunOutcome outcome =
                run(XorTask.class, "chance", "maxGens=2", "keepScores=true").get(0);
        assertThat(outcome.phase()).isEqualTo(RunMonitor.Phase.REFUSED);
        assertThat(outcome.message()).contains("keepScores=true", "depend on chance", "isDeterministic()");
    }

    @Test
    void stopAt_endsTheRunAtTheScore_andTheSameCommandHasNothingToDo() throws Exception {
        RunOutcome outcome =
                run(ExactXor.class, "stopped", "maxGens=300", "stopAt=0.6").get(0);
        assertThat(outcome.phase()).isEqualTo(RunMonitor.Phase.FINISHED);
        RunStatus status = RunStatus.read(folder.resolve("stopped/1M0")).orElseThrow();
        assertThat(status.best()).isGreaterThanOrEqualTo(0.6);
        assertThat(status.generation()).isBetween(1, 299).isEqualTo(status.generations());
        assertThat(Files.readAllLines(folder.resolve("stopped/1M0/generations.csv")))
                .hasSize(status.generation() + 2);
        RunOutcome again =
                run(ExactXor.class, "stopped", "maxGens=300", "stopAt=0.6").get(0);
        assertThat(again.phase()).isEqualTo(RunMonitor.Phase.ALREADY_FINISHED);
    }

    @Test
    void stoppedAndContinuedRun_equalsAnUninterruptedOne() throws Exception {
        run(ExactXor.class, "whole", "maxGens=40");
        run(ExactXor.class, "stopped", "maxGens=40", "stopAt=0.55", "keepScores=true");
        assertThat(RunStatus.read(folder.resolve("stopped/1M0")).orElseThrow().generation())
                .isLessThan(40);
        run(ExactXor.class, "stopped", "maxGens=40");
        assertThat(ExperimentRunnerTest.content(folder.resolve("stopped/1M0")))
                .isEqualTo(ExperimentRunnerTest.content(folder.resolve("whole/1M0")));
    }

    @Test
    void badValues_areRefusedBeforeTheStart() {
        assertThatThrownBy(() -> run(ExactXor.class, "bad", "stopAt=high"))
                .isInstanceOf(UserError.class)
                .hasMessage("stopAt=high: must be a number");
        assertThatThrownBy(() -> run(ExactXor.class, "bad", "stopAt=NaN"))
                .isInstanceOf(UserError.class)
                .hasMessage("stopAt=NaN: must be a number");
        assertThatThrownBy(() -> run(ExactXor.class, "bad", "checkpointEvery=never"))
                .isInstanceOf(UserError.class)
                .hasMessageStartingWith("checkpointEvery=never: must be auto");
        assertThat(folder.resolve("bad")).doesNotExist();
    }
}
