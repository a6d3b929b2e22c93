package mmneat.experiment.store;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.Optional;
import mmneat.experiment.PlainText;
import org.jspecify.annotations.Nullable;

/**
 * The state of a run, read from its files, whether or not a process works on it.
 *
 * @param directory the run's folder
 * @param experiment name of the experiment, for instance {@code blended-2M}
 * @param number number of the run
 * @param state its current state
 * @param status its progress; null if it was not started
 * @param signOfLife when the lock was last touched; null if the run is not locked
 * @param estimatedEnd when it will end; null if that is unknown
 */
public record RunView(
        Path directory,
        String experiment,
        int number,
        State state,
        @Nullable RunStatus status,
        @Nullable Instant signOfLife,
        @Nullable Instant estimatedEnd) {

    /**
     * The state of a run as a reader of its folder sees it: the state in {@link RunStatus}, corrected by the lock,
     * which tells whether a process is at work.
     */
    public enum State {
        /** All requested generations are complete, or the champion reached the score of {@code stopAt}. */
        FINISHED,
        /** A process works on it. */
        RUNNING,
        /** It was started and no process works on it. The same command continues it. */
        INTERRUPTED,
        /** An exception ended it. The same command tries again from the last checkpoint. */
        FAILED,
        /** It was requested and not yet started. */
        WAITING
    }

    /** Returns the view of a run that was not started. */
    public static RunView waiting(Path directory, String experiment, int number) {
        return new RunView(directory, experiment, number, State.WAITING, null, null, null);
    }

    /** Whether a folder is that of a run of this program. */
    public static boolean isRun(Path folder) {
        return new RunParametersFile(folder).exists()
                && (Files.exists(folder.resolve(RunLayout.STATUS)) || new CheckpointFile(folder).exists());
    }

    /** Reads a run's folder. */
    public static RunView read(Path directory, Instant now) throws IOException {
        Map<String, String> parameters = new RunParametersFile(directory).read();
        Optional<RunStatus> status = RunStatus.read(directory);
        Optional<RunLock.Sighting> lock = RunLock.look(directory);
        boolean worksNow =
                lock.filter(held -> held.seemsAlive(now, RunLock.Timing.USUAL)).isPresent();
        State state =
                worksNow ? State.RUNNING : status.map(RunView::restingState).orElse(State.INTERRUPTED);
        Instant end = null;
        if (worksNow && status.isPresent() && status.get().secondsPerGeneration() > 0) {
            RunStatus known = status.get();
            double seconds = known.secondsPerGeneration() * (known.generations() - known.generation() + 0.5);
            end = RunStatus.lastWritten(directory).plus(Duration.ofMillis((long) (seconds * 1000)));
        }
        return new RunView(
                directory,
                PlainText.shown(parameters.getOrDefault("log", "")),
                Integer.parseInt(parameters.getOrDefault("runNumber", "0")),
                state,
                status.orElse(null),
                lock.map(RunLock.Sighting::signOfLife).orElse(null),
                end);
    }

    /** Score of the champion of the last complete generation; NaN before the first. */
    public double bestScore() {
        return status == null ? Double.NaN : status.best();
    }

    /** Why the run failed; "null" if that was not written. */
    public String failure() {
        return String.valueOf(status == null ? null : status.message());
    }

    private static State restingState(RunStatus status) {
        return switch (status.state()) {
            case FINISHED -> status.generation() >= status.generations() ? State.FINISHED : State.INTERRUPTED;
            case FAILED -> State.FAILED;
            case RUNNING -> State.INTERRUPTED;
        };
    }
}
