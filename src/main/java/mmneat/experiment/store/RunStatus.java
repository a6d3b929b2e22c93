package mmneat.experiment.store;

import com.fasterxml.jackson.annotation.JsonInclude;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Optional;
import mmneat.experiment.PlainText;
import mmneat.experiment.TextFiles;
import org.jspecify.annotations.Nullable;

/**
 * The progress of a run, written to {@code status.json} for other programs. Nothing is resumed from it.
 *
 * @param state the state of the run when it wrote this
 * @param generation number of complete generations
 * @param generations number of requested generations
 * @param best score of the champion of the last complete generation; NaN before the first
 * @param median median score of that generation's parents; NaN before the first
 * @param stepsPerSecond simulated time steps per second of this process; 0 before the first generation
 * @param secondsPerGeneration seconds per generation of this process; 0 before the first generation
 * @param message why the run failed; null if it did not fail
 */
@JsonInclude(JsonInclude.Include.NON_NULL)
public record RunStatus(
        State state,
        int generation,
        int generations,
        double best,
        double median,
        double stepsPerSecond,
        double secondsPerGeneration,
        @Nullable String message) {

    /**
     * The state of a run as the run itself last wrote it. A run whose process was killed still says {@link #RUNNING};
     * {@link RunView.State} tells it from one that is at work.
     */
    public enum State {
        /** The run was started and has written nothing else since. */
        RUNNING,
        /** All generations requested at that time are complete, or the champion reached the score of {@code stopAt}. */
        FINISHED,
        /** An exception ended the run; {@link #message} tells why. */
        FAILED
    }

    private static final ObjectMapper JSON = JsonMapper.builder()
            .disable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
            .build();

    /**
     * Creates a status. Unprintable characters of the message become question marks: it may come from a file of another
     * person and is printed on terminals.
     *
     * @throws IllegalArgumentException if there is no state or a number of generations is negative
     */
    public RunStatus {
        if (state == null || generation < 0 || generations < 0) {
            throw new IllegalArgumentException("not the status of a run");
        }
        message = message == null ? null : PlainText.shown(message);
    }

    /** Reads the status in a run's folder; empty if there is no readable status. */
    public static Optional<RunStatus> read(Path directory) throws IOException {
        OrdinaryFiles.require(file(directory));
        try {
            byte[] json = TextFiles.bytes(file(directory), TextFiles.SETTINGS_MIB);
            return Optional.ofNullable(JSON.readValue(json, RunStatus.class));
        } catch (NoSuchFileException | JsonProcessingException e) {
            // The run was not started, or the file is not ours. The run's checkpoint counts, not this file.
            return Optional.empty();
        }
    }

    public void write(Path directory) throws IOException {
        byte[] json = JSON.writerWithDefaultPrettyPrinter().writeValueAsBytes(this);
        if (state == State.RUNNING) {
            // The next status is written soon.
            DurableFiles.replace(file(directory), json);
        } else {
            DurableFiles.write(file(directory), json);
        }
    }

    /**
     * Returns the status of a run that failed after it had written this status.
     *
     * @param wanted number of requested generations
     * @param why the message, one line
     */
    public RunStatus failed(int wanted, @Nullable String why) {
        return new RunStatus(State.FAILED, generation, wanted, best, median, stepsPerSecond, secondsPerGeneration, why);
    }

    /** Returns when the status of a run was last written. */
    static Instant lastWritten(Path directory) throws IOException {
        return Files.getLastModifiedTime(file(directory)).toInstant();
    }

    /**
     * Whether the run has finished with at least this number of generations. A run that {@code stopAt} ended early has
     * fewer; the reader of its folder sees it as finished because {@link #generations} then is the number it had.
     *
     * @param wanted number of requested generations
     */
    public boolean isFinished(int wanted) {
        return state == State.FINISHED && generation >= wanted;
    }

    private static Path file(Path directory) {
        return directory.resolve(RunLayout.STATUS);
    }
}
