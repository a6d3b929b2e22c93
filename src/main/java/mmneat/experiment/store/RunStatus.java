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

/**
 * The progress of a run, written to {@code status.json} for other programs. Nothing is resumed from it.
 *
 * @param state the activity of the run when it wrote this
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
        String message) {

    /** The activity of a run. */
    public enum State {
        RUNNING,
        FINISHED,
        FAILED
    }

    private static final ObjectMapper JSON = JsonMapper.builder()
            .disable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
            .build();

    /** The message may be from a file of someone else, and goes to terminals. */
    public RunStatus {
        message = message == null ? null : PlainText.shown(message);
    }

    /** Reads the status in a run's folder; empty if there is no readable status. */
    public static Optional<RunStatus> read(Path directory) throws IOException {
        SymbolicLinks.refuse(file(directory));
        try {
            return Optional.ofNullable(JSON.readValue(Files.readAllBytes(file(directory)), RunStatus.class));
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

    /** Returns this status, with the run failed. */
    public RunStatus failed(int wanted, String why) {
        return new RunStatus(State.FAILED, generation, wanted, best, median, stepsPerSecond, secondsPerGeneration, why);
    }

    /** Returns when the status of a run was last written. */
    static Instant lastWritten(Path directory) throws IOException {
        return Files.getLastModifiedTime(file(directory)).toInstant();
    }

    /** Whether all requested generations are complete. */
    public boolean isFinished(int wanted) {
        return state == State.FINISHED && generation >= wanted;
    }

    private static Path file(Path directory) {
        return directory.resolve(RunLayout.STATUS);
    }
}
