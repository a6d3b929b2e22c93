package mmneat.experiment;

import com.fasterxml.jackson.annotation.JsonPropertyOrder;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import mmneat.evolution.EvolutionState;
import mmneat.neat.io.GenotypeJson;

/**
 * All that a run needs to continue as if it had never stopped.
 *
 * @param format always {@value #FORMAT}
 * @param version version of the format
 * @param logs length in bytes of every log when the generation was over
 * @param evolution population, generator, counters
 */
@JsonPropertyOrder({"format", "version", "logs", "evolution"})
record Checkpoint(String format, int version, SortedMap<String, Long> logs, EvolutionState evolution) {

    private static final String FORMAT = "mmneat-checkpoint";
    private static final int VERSION = 1;
    private static final ObjectMapper JSON = JsonMapper.builder()
            .addModule(GenotypeJson.module())
            .enable(DeserializationFeature.FAIL_ON_NULL_CREATOR_PROPERTIES)
            .build();

    Checkpoint {
        if (!format.equals(FORMAT) || version != VERSION) {
            throw new IllegalArgumentException(
                    "must be " + FORMAT + " version " + VERSION + ", is " + format + " version " + version);
        }
    }

    static Checkpoint of(EvolutionState evolution, Map<String, Long> logs) {
        return new Checkpoint(FORMAT, VERSION, new TreeMap<>(logs), evolution);
    }

    byte[] toJson() {
        try {
            return JSON.writeValueAsBytes(this);
        } catch (JsonProcessingException e) {
            throw new IllegalStateException("the checkpoint cannot be written as JSON", e);
        }
    }

    /** @throws IOException if it is no checkpoint of this version; the message says why */
    static Checkpoint fromJson(byte[] json) throws IOException {
        return JSON.readValue(json, Checkpoint.class);
    }
}
