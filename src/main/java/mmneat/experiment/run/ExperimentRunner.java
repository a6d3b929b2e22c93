package mmneat.experiment.run;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import mmneat.evolution.DaemonThreads;
import mmneat.evolution.Task;
import mmneat.experiment.FileErrors;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.EvolutionParameters;
import mmneat.experiment.parameters.PublishedTask;
import mmneat.experiment.parameters.Tasks;
import mmneat.experiment.store.CheckpointFile;
import mmneat.experiment.store.DurableFiles;
import mmneat.experiment.store.GhostLocationsCopy;
import mmneat.experiment.store.OrdinaryFiles;
import mmneat.experiment.store.RunLock;
import mmneat.experiment.store.RunParametersFile;
import mmneat.experiment.store.RunStatus;
import mmneat.mspacman.TaskVersion;

/**
 * Executes the runs of a plan in parallel. A finished run is skipped and a started run is continued. The result of a
 * run does not depend on other runs.
 */
public final class ExperimentRunner {

    private final ExperimentPlan plan;
    private final List<RunMonitor> monitors;
    /** The task factory of each run, in the plan's order. */
    private final List<Supplier<Task>> tasks;

    private final CommitGate gate = new CommitGate();
    private final Set<RunLock> heldLocks = ConcurrentHashMap.newKeySet();

    /**
     * Prepares an experiment without starting it.
     *
     * @throws UserError if the task cannot be made, or if any of the runs was started with other parameters or has more
     *     generations than requested; then no run is started. What changes after this check makes a single run {@link
     *     RunMonitor.Phase#REFUSED}
     */
    public ExperimentRunner(ExperimentPlan plan) {
        this.plan = plan;
        tasks = tasks(plan);
        monitors = plan.runs().stream()
                .map(run -> new RunMonitor(run, System::nanoTime))
                .toList();
        EvolutionParameters.settings(
                plan.runs().get(0).parameters(), tasks.get(0).get());
        plan.runs().get(0).stopAt();
        CheckpointSchedule.of(plan.parameters().text("checkpointEvery"), System::nanoTime);
        for (RunPlan run : plan.runs()) {
            requireContinuable(run);
        }
    }

    /**
     * Checks that the plan can be executed, as far as possible before it starts: a missing file should not make thirty
     * cluster jobs fail.
     *
     * @throws UserError if not
     */
    static void requirePossible(ExperimentPlan plan) {
        new ExperimentRunner(plan);
    }

    private void requireFolder() {
        Path base = plan.base();
        try {
            DurableFiles.makeFolder(base);
        } catch (IOException e) {
            throw new UserError(
                    base + ": cannot be created: " + FileErrors.sentence(e)
                            + "; choose another folder with base=FOLDER",
                    e);
        }
        boolean isNew = plan.runs().stream().anyMatch(run -> !Files.exists(run.directory()));
        if (isNew && !Files.isWritable(base)) {
            throw new UserError(base + ": permission denied; choose another folder with base=FOLDER");
        }
    }

    private static void requireContinuable(RunPlan run) {
        RunParametersFile file = new RunParametersFile(run.directory());
        try {
            OrdinaryFiles.requireIn(run.directory());
            new CheckpointFile(run.directory()).requireNoOrphanedRun();
            if (file.exists()) {
                file.requireSame(run.parameters());
            }
            GhostLocationsCopy.requireSame(run.directory(), run.parameters());
            Optional<RunStatus> status = RunStatus.read(run.directory());
            if (status.isPresent() && !run.isFinished(status.get())) {
                run.requireAtLeast(status.get().generation());
            }
        } catch (IOException e) {
            throw FileErrors.unreadable(run.directory(), e);
        }
    }

    private static List<Supplier<Task>> tasks(ExperimentPlan plan) {
        if (PublishedTask.version(plan.parameters())
                .filter(TaskVersion.ISOLATED::equals)
                .isPresent()) {
            return plan.runs().stream()
                    .map(run -> Tasks.factory(GhostLocationsCopy.parameters(run.directory(), run.parameters())))
                    .toList();
        }
        return Collections.nCopies(plan.runs().size(), Tasks.factory(plan.parameters()));
    }

    /** The progress of each run, in the plan's order. */
    public List<RunMonitor> monitors() {
        return monitors;
    }

    /**
     * Executes all runs.
     *
     * @return the outcome of each run, in the plan's order
     * @throws UserError if the folder of the runs is not writable
     * @throws InterruptedException if the calling thread is interrupted; the runs are then stopped
     */
    public List<RunOutcome> run() throws InterruptedException {
        requireFolder();
        if (plan.runs().size() > 1) {
            recordRequested();
        }
        int threads = threads();
        boolean splitsRuns = plan.parameters().flag("parallelEvaluations");
        ExecutorService workers = Executors.newFixedThreadPool(
                splitsRuns ? 1 : Math.min(threads, plan.runs().size()), DaemonThreads.named("run"));
        try {
            List<Future<RunOutcome>> pending = new ArrayList<>();
            for (int i = 0; i < monitors.size(); i++) {
                RunMonitor monitor = monitors.get(i);
                RunWorker worker = new RunWorker(monitor.run(), tasks.get(i), threads, monitor, gate, heldLocks);
                pending.add(workers.submit(worker::work));
            }
            List<RunOutcome> outcomes = new ArrayList<>();
            for (Future<RunOutcome> future : pending) {
                outcomes.add(future.get());
            }
            return outcomes;
        } catch (ExecutionException e) {
            throw new IllegalStateException("a run's outcome was lost", e.getCause());
        } finally {
            workers.shutdownNow();
            // The caller may delete the folders after this returns. A second interruption does not wait.
            workers.awaitTermination(Long.MAX_VALUE, TimeUnit.NANOSECONDS);
        }
    }

    private void recordRequested() {
        try {
            ExperimentView.recordRequested(plan);
        } catch (IOException e) {
            throw new UserError(plan.base() + ": cannot be written to: " + FileErrors.reason(e), e);
        }
    }

    /** The requested number of threads; by default one per core. */
    private int threads() {
        int asked = plan.parameters().integer("threads");
        return asked == 0 ? Runtime.getRuntime().availableProcessors() : asked;
    }

    /**
     * Stops all runs so that the program can end: it completes current writes, prevents new ones, and releases the
     * locks. Call it when the process is told to end.
     *
     * @param patience how long to wait for current writes
     * @return whether all current writes were completed; if not, the last complete state is still on the disk
     */
    public boolean halt(Duration patience) throws InterruptedException, IOException {
        if (!gate.close(patience)) {
            return false;
        }
        for (RunLock lock : heldLocks) {
            lock.close();
        }
        return true;
    }
}
