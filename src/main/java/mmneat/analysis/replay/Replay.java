package mmneat.analysis.replay;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/** A recorded game that can be written as JSON for the page; made by a {@link ReplayRecorder}. */
public final class Replay {

    private final Map<String, Object> header = new LinkedHashMap<>();
    private final ReplayTitle title;
    private final int steps;
    private final int finalScore;
    private final int dataLength;

    Replay(
            ReplayTitle title,
            int steps,
            int finalScore,
            int detailEvery,
            int sensorScale,
            int activationScale,
            List<ReplayMaze> mazes,
            List<ReplayRecorder.Chapter> chapters,
            List<ReplayRecorder.Outcome> outcomes,
            ReplayNetwork network,
            List<Column> columns) {
        this.title = title;
        // The last state of each game is the result of its last step; it is not a step itself.
        this.steps = steps - Math.max(1, outcomes.size());
        this.finalScore = finalScore;
        header.put("heading", title.heading());
        header.put("subtitle", title.subtitle());
        header.put("steps", steps);
        header.put("detailEvery", detailEvery);
        header.put("sensorScale", sensorScale);
        header.put("activationScale", activationScale);
        header.put("mazes", mazes);
        header.put("chapters", chapters);
        header.put("outcomes", outcomes);
        header.put("network", network);
        header.put(
                "columns",
                columns.stream().map(c -> List.of(c.name(), c.width())).toList());
        String data = pack(columns);
        dataLength = data.length();
        header.put("data", data);
    }

    public ReplayTitle title() {
        return title;
    }

    /** Number of steps that were played. */
    public int steps() {
        return steps;
    }

    /** Points of all its games together. */
    public int finalScore() {
        return finalScore;
    }

    /** Number of characters of the compressed columns, which are nearly all of the page. */
    int dataLength() {
        return dataLength;
    }

    /** The recording as JSON; {@code data} is the base64 of the zlib-compressed columns. */
    public String json() {
        try {
            return new ObjectMapper().writeValueAsString(header);
        } catch (JsonProcessingException e) {
            throw new IllegalStateException(e);
        }
    }

    private static String pack(List<Column> columns) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        columns.forEach(column -> column.writeTo(all));
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        Deflater deflater = new Deflater(Deflater.DEFAULT_COMPRESSION);
        try (DeflaterOutputStream out = new DeflaterOutputStream(packed, deflater)) {
            all.writeTo(out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } finally {
            deflater.end();
        }
        return Base64.getEncoder().encodeToString(packed.toByteArray());
    }
}
