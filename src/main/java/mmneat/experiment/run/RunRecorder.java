package mmneat.experiment.run;

import java.io.IOException;
import java.util.List;
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
import org.jspecify.annotations.Nullable;

/**
 * The observer that writes the files of a run. It holds a generation's files in memory until the next checkpoint is
 * due. Then it writes the files, and after them the checkpoint. A run that continues from a checkpoint writes later
 * files again.
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
    private final SyncSchedule sync = new SyncSchedule(System::nanoTime);
    private final CheckpointSchedule checkpoints;
    private int completedHere;

    /** The state after the last complete generation; null before the first of this process. */
    private @Nullable EvolutionState latest;

    private RunStatus status;

    RunRecorder(
            Task task,
            RunFolder folder,
            RunFiles files,
            GenerationTable table,
            CheckpointFile checkpoint,
            RunLock lock,
            CommitGate gate,
            RunMonitor monitor,
            CheckpointSchedule checkpoints,
            RunStatus status) {
        this.task = task;
        this.folder = folder;
        this.files = files;
        this.checkpoint = checkpoint;
        this.lock = lock;
        this.gate = gate;
        this.monitor = monitor;
        this.checkpoints = checkpoints;
        this.status = status;
        this.table = table;
    }

    /** The last status that was written. */
    RunStatus status() {
        return status;
    }

    /** The best champion score among parents. */
    double bestScore(List<Individual> parents) {
        return parents.stream()
                .mapToDouble(parent -> task.championScore(parent.evaluation()))
                .max()
                .orElse(Double.NEGATIVE_INFINITY);
    }

    @Override
    public void evaluated(int generation, int done, int total, Individual individual) {
        monitor.evaluated(individual.evaluation().outcomes().steps());
    }

    @Override
    public void generationCompleted(Generation generation, EvolutionState next) {
        completedHere++;
        files.generationCompleted(generation, next);
        folder.append(RunLayout.GENERATIONS, (generation.number() == 0 ? table.header() : "") + table.row(generation));
        latest = next;
        boolean isLast = next.generation() >= status.generations();
        if (!checkpoints.isDue(next.generation(), isLast)) {
            announce(generation, next.generation());
            return;
        }
        commit(() -> {
            folder.write(
                    RunLayout.CHAMPION,
                    GenotypeJson.write(generation.champion(task).genotype()));
            saveCheckpoint(next, isLast);
            checkpoints.done();
            record(generation, next.generation(), RunStatus.State.RUNNING);
        });
    }

    @Override
    public void completed(Generation finalParents) {
        commit(() -> {
            if (latest != null && latest.generation() < status.generations()) {
                // The run ends before its last generation.
                saveCheckpoint(latest, true);
            }
            files.completed(finalParents);
            folder.append(
                    RunLayout.GENERATIONS,
                    (finalParents.number() == 0 ? table.header() : "") + table.row(finalParents));
            folder.flush();
            folder.syncAll();
            // No checkpoint: that of the last generation remains, so that the run can be continued later.
            record(finalParents, finalParents.number(), RunStatus.State.FINISHED);
        });
    }

    private void saveCheckpoint(EvolutionState next, boolean isLast) throws IOException {
        // The last checkpoint must remain usable for more generations, after later files have replaced some of its
        // files.
        boolean syncs = isLast || sync.isDue(folder.unsynced().count());
        if (syncs) {
            files.writeNewestNetworks(next);
        }
        Map<String, Long> logs = folder.flush();
        if (syncs) {
            folder.sync();
            sync.done();
        }
        checkpoint.save(Checkpoint.of(next, logs, folder.unsynced().stretches()));
    }

    private void record(Generation generation, int completed, RunStatus.State state) throws IOException {
        Score score = announce(generation, completed);
        status = new RunStatus(
                state,
                completed,
                state == RunStatus.State.FINISHED ? completed : status.generations(),
                score.best(),
                score.median(),
                monitor.stepsPerSecond(),
                completedHere == 0 ? 0 : monitor.seconds() / completedHere,
                null);
        status.write(folder.directory());
    }

    /** The champion's score and the median score of a generation's parents. */
    private record Score(double best, double median) {}

    private Score announce(Generation generation, int completed) {
        double[] scores = GenerationTable.scores(task, generation);
        Score score = new Score(scores[scores.length - 1], GenerationTable.median(scores));
        monitor.generationCompleted(completed, score.best(), score.median());
        return score;
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

    /** Thrown by the observer to end an evolution; the cause says why. */
    static final class RunStoppedException extends RuntimeException {
        private static final long serialVersionUID = 1;

        RunStoppedException(Exception cause) {
            super(cause);
        }
    }
}
