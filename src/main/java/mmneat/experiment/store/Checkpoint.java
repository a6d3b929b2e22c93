package mmneat.experiment.store;

import com.fasterxml.jackson.annotation.JsonProperty;
import com.fasterxml.jackson.annotation.JsonPropertyOrder;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.Map;
import java.util.Objects;
import java.util.SortedMap;
import java.util.TreeMap;
import mmneat.evolution.EvolutionState;
import mmneat.experiment.JsonProblem;
import mmneat.experiment.PlainText;
import mmneat.neat.io.GenotypeJson;
import mmneat.neat.io.StrictJson;

/**
 * The complete state of a run between two generations. A run that continues from it gives the same results as one that
 * was never stopped.
 *
 * @param format always {@value #FORMAT}
 * @param version version of the format
 * @param logs length in bytes of every log at the end of the generation
 * @param unsynced the parts of the run's files that were written but not synced to the disk; empty if all files survive
 *     a failure of the machine
 * @param evolution population, generator, counters
 */
@JsonPropertyOrder({"format", "version", "logs", "unforced", "evolution"})
public record Checkpoint(
        String format,
        int version,
        SortedMap<String, Long> logs,
        @JsonProperty("unforced") SortedMap<String, UnsyncedFiles.Stretch> unsynced,

        EvolutionState evolution) {

    private static final String FORMAT = "mmneat-checkpoint";
    private static final int VERSION = 1;
    private static final ObjectMapper JSON =
            StrictJson.mapper().addModule(GenotypeJson.module()).build();

    public Checkpoint {
        if (!FORMAT.equals(format) || version != VERSION) {
            throw new IllegalArgumentException(
                    "must be " + FORMAT + " version " + VERSION + ", is " + format + " version " + version);
        }
        Objects.requireNonNull(logs, "logs");
        Objects.requireNonNull(evolution, "evolution");
        // Earlier versions of the program synced everything and did not write this field.
        unsynced = unsynced == null ? new TreeMap<>() : unsynced;
    }

    public static Checkpoint of(
            EvolutionState evolution, Map<String, Long> logs, SortedMap<String, UnsyncedFiles.Stretch> unsynced) {
        return new Checkpoint(FORMAT, VERSION, new TreeMap<>(logs), unsynced, evolution);
    }

    /** Whether all files of the run were synced when this was written. */
    public boolean wasSynced() {
        return unsynced.isEmpty();
    }

    /** Returns this checkpoint, marked as synced. */
    public Checkpoint synced() {
        return new Checkpoint(format, version, logs, new TreeMap<>(), evolution);
    }

    byte[] toJson() {
        try {
            return JSON.writeValueAsBytes(this);
        } catch (JsonProcessingException e) {
            throw new IllegalStateException("the checkpoint cannot be written as JSON", e);
        }
    }

    /**
     * Reads what {@link #toJson} wrote.
     *
     * @throws IOException if it is not a checkpoint of this version; the message is one line
     */
    static Checkpoint fromJson(byte[] json) throws IOException {
        try {
            Checkpoint checkpoint = JSON.readValue(json, Checkpoint.class);
            if (checkpoint == null) {
                throw new IOException("it is null");
            }
            return checkpoint;
        } catch (JsonProcessingException e) {
            throw new IOException(
                    "it is not a checkpoint of this version of the program: " + PlainText.shown(JsonProblem.of(e)), e);
        }
    }
}
