package mmneat.experiment.run;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.ClosedByInterruptException;
import java.util.EnumMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import mmneat.evolution.BadEvaluationException;
import mmneat.evolution.Evaluator;
import mmneat.evolution.Evolution;
import mmneat.evolution.EvolutionSettings;
import mmneat.evolution.EvolutionState;
import mmneat.evolution.FailedEvaluationException;
import mmneat.evolution.ParallelEvaluator;
import mmneat.evolution.ScoreKeepingEvaluator;
import mmneat.evolution.SequentialEvaluator;
import mmneat.evolution.Task;
import mmneat.experiment.FileErrors;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;
import mmneat.experiment.original.RunFiles;
import mmneat.experiment.parameters.EvolutionParameters;
import mmneat.experiment.parameters.Parameters;
import mmneat.experiment.store.Checkpoint;
import mmneat.experiment.store.CheckpointCheck;
import mmneat.experiment.store.CheckpointFile;
import mmneat.experiment.store.DurableFiles;
import mmneat.experiment.store.GenerationTable;
import mmneat.experiment.store.GhostLocationsCopy;
import mmneat.experiment.store.OrdinaryFiles;
import mmneat.experiment.store.RunFolder;
import mmneat.experiment.store.RunLock;
import mmneat.experiment.store.RunParametersFile;
import mmneat.experiment.store.RunStatus;
import mmneat.neat.BadPartException;
import org.jspecify.annotations.Nullable;

/** Executes one run on the calling thread, from its start or its checkpoint to its end. */
final class RunWorker {

    private final RunPlan run;
    private final Supplier<Task> tasks;
    private final int evaluationThreads;
    private final RunMonitor monitor;
    private final CommitGate gate;
    private final Set<RunLock> heldLocks;

    /** Whether the folder has passed the checks, so that its files may be changed. */
    private boolean isFolderAccepted;

    /**
     * @param tasks makes tasks, each for one thread
     * @param evaluationThreads threads for {@code parallelEvaluations}
     * @param heldLocks the set of held locks, to which the run's lock is added while it is held; thread-safe
     */
    RunWorker(
            RunPlan run,
            Supplier<Task> tasks,
            int evaluationThreads,
            RunMonitor monitor,
            CommitGate gate,
            Set<RunLock> heldLocks) {
        this.run = run;
        this.tasks = tasks;
        this.evaluationThreads = evaluationThreads;
        this.monitor = monitor;
        this.gate = gate;
        this.heldLocks = heldLocks;
    }

    /** Executes the run. Every failure is reported in the outcome. */
    RunOutcome work() {
        RunOutcome outcome = outcome();
        monitor.ended(outcome.phase());
        return outcome;
    }

    private RunOutcome outcome() {
        try {
            OrdinaryFiles.requireIn(run.directory());
            Optional<RunStatus> status = RunStatus.read(run.directory());
            if (status.isPresent() && run.isFinished(status.get())) {
                return new RunOutcome(run, RunMonitor.Phase.ALREADY_FINISHED, status.get(), null, null);
            }
            return evolveLocked();
        } catch (Exception | Error e) {
            return outcomeOf(e);
        }
    }

    private RunOutcome evolveLocked() throws Exception {
        gate.pass(() -> DurableFiles.makeFolder(run.directory()));
        RunLock lock = RunLock.acquire(run.directory(), RunLock.Timing.USUAL);
        try {
            // A listed lock is released when the program ends, so it must be listed before that.
            gate.pass(() -> heldLocks.add(lock));
            return evolveOrFail(lock);
        } finally {
            heldLocks.remove(lock);
            lock.close();
        }
    }

    /** Evolves. A failure is written to the status while this process holds the lock. */
    private RunOutcome evolveOrFail(RunLock lock) {
        try {
            return evolve(lock);
        } catch (Exception | Error e) {
            RunOutcome outcome = outcomeOf(e);
            return outcome.phase() == RunMonitor.Phase.FAILED ? recorded(outcome, lock) : outcome;
        }
    }

    /** Maps the exception that ended a run to its outcome. */
    private RunOutcome outcomeOf(Throwable e) {
        if (e instanceof RunRecorder.RunStoppedException || e instanceof UncheckedIOException) {
            return outcomeOf(Objects.requireNonNull(e.getCause()));
        }
        if (e instanceof RunLock.HeldException) {
            return new RunOutcome(run, RunMonitor.Phase.IN_USE, null, e.getMessage(), null);
        }
        if (isInterruption(e)) {
            return new RunOutcome(run, RunMonitor.Phase.STOPPED, null, "stopped", null);
        }
        if (e instanceof UserError && !isFolderAccepted) {
            return new RunOutcome(run, RunMonitor.Phase.REFUSED, null, e.getMessage(), null);
        }
        if (e instanceof UserError) {
            return failed(e.getMessage(), null);
        }
        if (e instanceof BadPartException) {
            return failed(e.getMessage(), null);
        }
        if (e instanceof BadEvaluationException) {
            return failed("task=" + run.parameters().text("task") + ": " + e.getMessage(), null);
        }
        if (e instanceof FailedEvaluationException failed) {
            // The message says everything about a part of the user's own; a task may fail anywhere.
            Throwable thrown = failed.thrown() instanceof BadPartException ? null : failed.thrown();
            return failed("task=" + run.parameters().text("task") + ": " + e.getMessage(), thrown);
        }
        if (e instanceof OutOfMemoryError) {
            return failed(
                    "out of memory; give Java more memory with the option -Xmx, or use smaller networks or fewer"
                            + " trials",
                    null);
        }
        return e instanceof IOException file ? failed(fileMessage(file), null) : failed(PlainText.shown(e), e);
    }

    /**
     * Whether the run was interrupted. An interruption during writing appears as an exception of the file's channel.
     */
    private static boolean isInterruption(Throwable e) {
        return e instanceof CancellationException
                || e instanceof InterruptedException
                || e instanceof ClosedByInterruptException;
    }

    private RunOutcome evolve(RunLock lock) throws IOException {
        RunParametersFile parametersFile = new RunParametersFile(run.directory());
        if (parametersFile.exists()) {
            parametersFile.requireSame(run.parameters());
        }
        Task task = tasks.get();
        requireDeterminism(task);
        EvolutionSettings settings = EvolutionParameters.settings(run.parameters(), task);
        RunFolder folder = new RunFolder(run.directory(), run.prefix());
        RunFiles files = new RunFiles(folder, task, files(settings));
        CheckpointFile checkpoint = new CheckpointFile(run.directory());

        GhostLocationsCopy.requireSame(run.directory(), run.parameters());
        Optional<Checkpoint> saved = checkpoint.load(new CheckpointCheck(settings, run.prefix()));
        if (saved.isPresent()) {
            run.requireAtLeast(saved.get().evolution().generation());
        } else {
            checkpoint.requireNoOrphanedRun();
        }
        isFolderAccepted = true;
        EvolutionState state = saved.isPresent()
                ? resume(saved.get(), folder, files, checkpoint)
                : begin(EvolutionState.initial(settings), folder, files, checkpoint);
        GhostLocationsCopy.keep(run.directory(), run.parameters());
        parametersFile.write(run.parameters());
        RunStatus status = new RunStatus(
                RunStatus.State.RUNNING, state.generation(), run.generations(), Double.NaN, Double.NaN, 0, 0, null);
        status.write(run.directory());
        CheckpointSchedule checkpoints =
                CheckpointSchedule.of(run.parameters().text("checkpointEvery"), System::nanoTime);
        GenerationTable table = GenerationTable.in(
                run.directory(), task, settings.initialNetworks().layout());
        RunRecorder recorder =
                new RunRecorder(task, folder, files, table, checkpoint, lock, gate, monitor, checkpoints, status);
        monitor.started(state.generation());
        evolve(settings, state, task, recorder);
        String damage = checkpoint.damage().isEmpty()
                ? null
                : run.directory() + ": continued from its previous checkpoint, " + checkpoint.damage();
        return new RunOutcome(run, RunMonitor.Phase.FINISHED, recorder.status(), damage, null);
    }

    private void requireDeterminism(Task task) {
        if (run.parameters().flag("keepScores") && !task.isDeterministic()) {
            throw new UserError(
                    "keepScores=true: the scores of task=" + run.parameters().text("task")
                            + " depend on chance, so parents must be evaluated again; leave it out, or let isDeterministic() of"
                            + " the task return true");
        }
    }

    /**
     * Creates the initial state and writes the checkpoint before all other files. A folder with files but no checkpoint
     * belongs to another run.
     */
    private static EvolutionState begin(
            EvolutionState initial, RunFolder folder, RunFiles files, CheckpointFile checkpoint) throws IOException {
        checkpoint.save(Checkpoint.of(initial, Map.of(), new TreeMap<>()));
        files.begin(initial);
        folder.flush();
        return initial;
    }

    private EvolutionState resume(Checkpoint last, RunFolder folder, RunFiles files, CheckpointFile checkpoint)
            throws IOException {
        folder.cutTo(last.logs());
        if (last.evolution().generation() == 0) {
            files.begin(last.evolution());
        } else {
            files.writeNewestNetworks(last.evolution());
        }
        folder.flush();
        if (!last.wasSynced()) {
            DurableFiles.sync(last.unsynced().keySet().stream()
                    .map(run.directory()::resolve)
                    .toList());
            checkpoint.save(last.synced());
        }
        return last.evolution();
    }

    private Set<RunFiles.Choice> files(EvolutionSettings settings) {
        Parameters parameters = run.parameters();
        Map<RunFiles.Choice, Boolean> choices = new EnumMap<>(RunFiles.Choice.class);
        choices.put(RunFiles.Choice.LOGS, parameters.flag("io"));
        choices.put(RunFiles.Choice.NETWORKS, parameters.flag("netio"));
        choices.put(
                RunFiles.Choice.MODULE_COUNTS,
                settings.initialNetworks().layout().hasPreferenceNeurons()
                        || settings.initialNetworks().layout().modules() > 1);
        choices.put(RunFiles.Choice.NEWEST_NETWORKS_ONLY, parameters.flag("cleanOldNetworks"));
        choices.values().removeIf(wanted -> !wanted);
        return choices.keySet();
    }

    private void evolve(EvolutionSettings settings, EvolutionState state, Task task, RunRecorder recorder) {
        if (run.parameters().flag("parallelEvaluations")) {
            try (ParallelEvaluator evaluator = new ParallelEvaluator(tasks, evaluationThreads, run.seed())) {
                evolve(settings, state, withKeptScores(evaluator), recorder);
            }
        } else {
            evolve(settings, state, withKeptScores(new SequentialEvaluator(task)), recorder);
        }
    }

    private Evaluator withKeptScores(Evaluator evaluator) {
        return run.parameters().flag("keepScores") ? new ScoreKeepingEvaluator(evaluator) : evaluator;
    }

    private void evolve(EvolutionSettings settings, EvolutionState state, Evaluator evaluator, RunRecorder recorder) {
        double stopAt = run.stopAt();
        new Evolution(settings, state, evaluator, recorder, parents -> recorder.bestScore(parents) >= stopAt).run();
    }

    private RunOutcome failed(@Nullable String message, @Nullable Throwable failure) {
        return new RunOutcome(run, RunMonitor.Phase.FAILED, null, message, failure);
    }

    /** Writes the failure to the status, which keeps the run's progress, and returns the outcome with it. */
    private RunOutcome recorded(RunOutcome failed, RunLock lock) {
        try {
            RunStatus last = RunStatus.read(run.directory())
                    .orElseGet(() -> new RunStatus(
                            RunStatus.State.RUNNING, 0, run.generations(), Double.NaN, Double.NaN, 0, 0, null));
            RunStatus status = last.failed(run.generations(), failed.message());
            gate.pass(() -> {
                lock.requireHeld();
                status.write(run.directory());
            });
            return new RunOutcome(run, failed.phase(), status, failed.message(), failed.failure());
        } catch (Exception e) {
            // The most likely failure is a full disk. The message still reaches the user.
            return new RunOutcome(run, failed.phase(), null, failed.message(), withSuppressed(failed.failure(), e));
        }
    }

    private static @Nullable Throwable withSuppressed(@Nullable Throwable failure, Exception second) {
        if (failure != null) {
            failure.addSuppressed(second);
        }
        return failure;
    }

    private String fileMessage(IOException e) {
        return "cannot write or read in " + run.directory() + ": " + FileErrors.sentence(e)
                + "; complete generations are kept: solve this problem, then give the same command again";
    }
}
