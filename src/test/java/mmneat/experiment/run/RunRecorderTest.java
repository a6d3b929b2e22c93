package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import mmneat.evolution.Evolution;
import mmneat.evolution.EvolutionSettings;
import mmneat.evolution.EvolutionState;
import mmneat.evolution.SequentialEvaluator;
import mmneat.evolution.Task;
import mmneat.evolution.XorTask;
import mmneat.experiment.original.RunFiles;
import mmneat.experiment.parameters.EvolutionParameters;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.parameters.Tasks;
import mmneat.experiment.store.CheckpointFile;
import mmneat.experiment.store.GenerationTable;
import mmneat.experiment.store.RunFolder;
import mmneat.experiment.store.RunLock;
import mmneat.experiment.store.RunStatus;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RunRecorderTest {

    @TempDir
    Path directory;

    @Test
    void completeRun_isOnTheDiskWithAllItsFiles() throws Exception {
        RunPlan run = ExperimentPlan.of(new ParameterReader(ParameterCatalogue.load())
                        .read(List.of("task=" + XorTask.class.getName(), "mu=3", "maxGens=2"))
                        .parameters())
                .runs()
                .get(0);
        Task task = Tasks.factory(run.parameters()).get();
        EvolutionSettings settings = EvolutionParameters.settings(run.parameters(), task);
        RunFolder folder = new RunFolder(directory, run.prefix());
        RunStatus begun = new RunStatus(RunStatus.State.RUNNING, 0, 2, Double.NaN, Double.NaN, 0, 0, null);
        try (RunLock lock = RunLock.acquire(directory, RunLock.Timing.USUAL)) {
            RunRecorder recorder = new RunRecorder(
                    task,
                    folder,
                    new RunFiles(
                            folder,
                            task,
                            Set.of(
                                    RunFiles.Choice.LOGS,
                                    RunFiles.Choice.NETWORKS,
                                    RunFiles.Choice.NEWEST_NETWORKS_ONLY)),
                    GenerationTable.in(
                            directory, task, settings.initialNetworks().layout()),
                    new CheckpointFile(directory),
                    lock,
                    new CommitGate(),
                    new RunMonitor(run, System::nanoTime),
                    CheckpointSchedule.of("auto", System::nanoTime),
                    begun);
            new Evolution(settings, EvolutionState.initial(settings), new SequentialEvaluator(task), recorder).run();
            assertThat(recorder.status().isFinished(2)).isTrue();
            assertThat(folder.unsynced().count()).isZero();
        }
    }
}
