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

/**
 * The progress of a run, as written to its file {@code status.json} for readers outside. Nothing is resumed from it.
 *
 * @param state what the run was doing when it wrote this
 * @param generation generations that are complete
 * @param generations generations that are asked for
 * @param best score of the champion of the last complete generation; NaN before the first
 * @param median median score of that generation's parents; NaN before the first
 * @param stepsPerSecond simulated time steps per second of this process's work; 0 before the first generation
 * @param secondsPerGeneration of this process; 0 before the first generation
 * @param message why it failed; null otherwise
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

    /** What a run was doing. */
    public enum State {
        RUNNING,
        FINISHED,
        FAILED
    }

    private static final ObjectMapper JSON = JsonMapper.builder()
            .disable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
            .build();

    /** The status in a run's folder; empty if there is none that can be read. */
    public static Optional<RunStatus> read(Path directory) throws IOException {
        SymbolicLinks.refuse(file(directory));
        try {
            return Optional.ofNullable(JSON.readValue(Files.readAllBytes(file(directory)), RunStatus.class));
        } catch (NoSuchFileException | JsonProcessingException e) {
            // Not begun, or not a file of ours: the run's checkpoint counts, not this file.
            return Optional.empty();
        }
    }

    public void write(Path directory) throws IOException {
        byte[] json = JSON.writerWithDefaultPrettyPrinter().writeValueAsBytes(this);
        if (state == State.RUNNING) {
            // The next one is soon there.
            DurableFiles.replace(file(directory), json);
        } else {
            DurableFiles.write(file(directory), json);
        }
    }

    /** The status of a run that had come so far and then failed. */
    public RunStatus failed(int wanted, String why) {
        return new RunStatus(State.FAILED, generation, wanted, best, median, stepsPerSecond, secondsPerGeneration, why);
    }

    /** When the status of a run was written last. */
    static Instant lastWritten(Path directory) throws IOException {
        return Files.getLastModifiedTime(file(directory)).toInstant();
    }

    /** Whether the generations that are wanted are all complete. */
    public boolean isFinished(int wanted) {
        return state == State.FINISHED && generation >= wanted;
    }

    private static Path file(Path directory) {
        return directory.resolve(RunLayout.STATUS);
    }
}
