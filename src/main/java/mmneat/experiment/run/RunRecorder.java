package mmneat.experiment.run;

import java.io.IOException;
import java.util.Map;
import mmneat.evolution.EvolutionObserver;
import mmneat.evolution.EvolutionState;
import mmneat.evolution.Generation;
import mmneat.evolution.Individual;
import mmneat.evolution.Task;
import mmneat.experiment.original.RunFiles;
import mmneat.experiment.store.Checkpoint;
import mmneat.experiment.store.CheckpointFile;
import mmneat.experiment.store.GenerationTable;
import mmneat.experiment.store.RunFolder;
import mmneat.experiment.store.RunLayout;
import mmneat.experiment.store.RunLock;
import mmneat.experiment.store.RunStatus;
import mmneat.neat.io.GenotypeJson;

/**
 * Writes all that a run leaves behind: after each generation its files and then, as the last thing, the checkpoint. What is
 * there between two checkpoints belongs to the older one.
 */
final class RunRecorder implements EvolutionObserver {

    private final Task task;
    private final RunFolder folder;
    private final RunFiles files;
    private final CheckpointFile checkpoint;
    private final RunLock lock;
    private final CommitGate gate;
    private final RunMonitor monitor;
    private final GenerationTable table;
    private final SyncSchedule forcing = new SyncSchedule(System::nanoTime);
    private int completedHere;
    private RunStatus status;

    RunRecorder(
            Task task,
            RunFolder folder,
            RunFiles files,
            CheckpointFile checkpoint,
            RunLock lock,
            CommitGate gate,
            RunMonitor monitor,
            RunStatus status) {
        this.task = task;
        this.folder = folder;
        this.files = files;
        this.checkpoint = checkpoint;
        this.lock = lock;
        this.gate = gate;
        this.monitor = monitor;
        this.status = status;
        table = new GenerationTable(task);
    }

    /** The last status that was written. */
    RunStatus status() {
        return status;
    }

    @Override
    public void evaluated(int generation, int done, int total, Individual individual) {
        monitor.evaluated(individual.evaluation().outcomes().steps());
    }

    @Override
    public void generationCompleted(Generation generation, EvolutionState next) {
        completedHere++;
        commit(() -> {
            files.generationCompleted(generation, next);
            folder.append(
                    RunLayout.GENERATIONS, (generation.number() == 0 ? table.header() : "") + table.row(generation));
            folder.write(
                    RunLayout.CHAMPION,
                    GenotypeJson.write(generation.champion(task).genotype()));
            saveCheckpoint(next);
            record(generation, next.generation(), RunStatus.State.RUNNING);
        });
    }

    @Override
    public void completed(Generation finalParents) {
        commit(() -> {
            files.completed(finalParents);
            folder.append(
                    RunLayout.GENERATIONS,
                    (finalParents.number() == 0 ? table.header() : "") + table.row(finalParents));
            folder.flush();
            folder.forceAll();
            // No checkpoint: that of the last generation stays, so that the run can be continued with more generations.
            record(finalParents, finalParents.number(), RunStatus.State.FINISHED);
        });
    }

    private void saveCheckpoint(EvolutionState next) throws IOException {
        Map<String, Long> logs = folder.flush();
        // The last one must be good for continuing with more generations, when later files have replaced some that it
        // knows.
        boolean isLast = next.generation() >= status.generations();
        if (isLast || forcing.isDue(folder.unforced().count())) {
            files.writeNewestNetworks(next);
            folder.force();
            forcing.done();
        }
        checkpoint.save(Checkpoint.of(next, logs, folder.unforced().stretches()));
    }

    private void record(Generation generation, int completed, RunStatus.State state) throws IOException {
        double[] scores = GenerationTable.scores(task, generation);
        double best = scores[scores.length - 1];
        double median = GenerationTable.median(scores);
        monitor.generationCompleted(completed, best, median);
        status = new RunStatus(
                state,
                completed,
                status.generations(),
                best,
                median,
                monitor.stepsPerSecond(),
                completedHere == 0 ? 0 : monitor.seconds() / completedHere,
                null);
        status.write(folder.directory());
    }

    private void commit(CommitGate.Commit commit) {
        try {
            gate.pass(() -> {
                lock.requireHeld();
                commit.run();
            });
        } catch (RuntimeException e) {
            throw e;
        } catch (Exception e) {
            throw new RunStoppedException(e);
        }
    }

    /** Ends an evolution from inside its observer; the cause says why. */
    static final class RunStoppedException extends RuntimeException {
        private static final long serialVersionUID = 1;

        RunStoppedException(Exception cause) {
            super(cause);
        }
    }
}
