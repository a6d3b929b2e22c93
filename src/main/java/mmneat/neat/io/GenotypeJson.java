package mmneat.neat.io;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.databind.DeserializationContext;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonMappingException;
import com.fasterxml.jackson.databind.MapperFeature;
import com.fasterxml.jackson.databind.ObjectReader;
import com.fasterxml.jackson.databind.ObjectWriter;
import com.fasterxml.jackson.databind.SerializerProvider;
import com.fasterxml.jackson.databind.deser.std.StdDeserializer;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.module.SimpleModule;
import com.fasterxml.jackson.databind.ser.std.StdSerializer;
import java.io.IOException;
import java.util.stream.Collectors;
import mmneat.neat.Genotype;

/**
 * The JSON form of a genotype, described in docs/genotype-format.md.
 *
 * <p>Reading checks everything: format name and version, every field's presence and type, and that the genes make a network. An
 * error names the field. Numbers are written so that reading gives the same double.
 */
public final class GenotypeJson {

    /** A genotype takes kilobytes: larger documents, deeper nesting and longer words are refused. */
    private static final StreamReadConstraints LIMITS = StreamReadConstraints.builder()
            .maxNestingDepth(8)
            .maxDocumentLength(GenotypeFiles.MAX_BYTES)
            .maxStringLength(100)
            .maxNameLength(100)
            .maxNumberLength(100)
            .build();

    private static final JsonMapper MAPPER = mapper();
    private static final ObjectReader READER = MAPPER.readerFor(GenotypeDocument.class);
    private static final ObjectWriter WRITER = MAPPER.writer(new OneGenePerLine());

    private GenotypeJson() {}

    private static JsonMapper mapper() {
        JsonMapper mapper = JsonMapper.builder()
                .enable(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES)
                .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
                .enable(JsonParser.Feature.STRICT_DUPLICATE_DETECTION)
                .disable(DeserializationFeature.ACCEPT_FLOAT_AS_INT)
                .disable(MapperFeature.ALLOW_COERCION_OF_SCALARS)
                .build();
        mapper.getFactory().setStreamReadConstraints(LIMITS);
        return mapper;
    }

    /** The JSON text of a genotype: one gene a line. */
    public static String write(Genotype genotype) {
        try {
            return WRITER.writeValueAsString(GenotypeDocument.of(genotype)) + "\n";
        } catch (JsonProcessingException e) {
            throw new IllegalStateException("genotype " + genotype.id() + " cannot be written as JSON", e);
        }
    }

    /**
     * Reads a genotype.
     *
     * @throws GenotypeFormatException if the text is not a genotype in JSON; the message names the field
     */
    public static Genotype read(String json) throws GenotypeFormatException {
        try {
            GenotypeDocument document = READER.readValue(json);
            if (document == null) {
                throw new GenotypeFormatException("the JSON document is empty");
            }
            return document.toGenotype();
        } catch (JacksonException e) {
            throw new GenotypeFormatException(messageOf(e), e);
        } catch (IllegalArgumentException e) {
            throw new GenotypeFormatException(e.getMessage(), e);
        }
    }

    /** Lets Jackson write and read genotypes in this form as parts of larger documents, such as checkpoints. */
    public static SimpleModule module() {
        SimpleModule module = new SimpleModule("genotypes");
        module.addSerializer(new Serializer());
        module.addDeserializer(Genotype.class, new Deserializer());
        return module;
    }

    /** Field, what is wrong, and where in the text; in one line. */
    private static String messageOf(JacksonException e) {
        String field = e instanceof JsonMappingException mapping
                ? mapping.getPath().stream()
                        .map(step ->
                                step.getFieldName() == null ? "[" + step.getIndex() + "]" : "." + step.getFieldName())
                        .collect(Collectors.joining())
                : "";
        String where = e.getLocation() == null
                ? ""
                : " (line " + e.getLocation().getLineNr() + ", column "
                        + e.getLocation().getColumnNr() + ")";
        String what = e.getOriginalMessage().lines().findFirst().orElse("not a genotype");
        return (field.isEmpty() ? "" : field.substring(field.startsWith(".") ? 1 : 0) + ": ") + what + where;
    }

    private static final class Serializer extends StdSerializer<Genotype> {
        Serializer() {
            super(Genotype.class);
        }

        @Override
        public void serialize(Genotype genotype, JsonGenerator generator, SerializerProvider provider)
                throws IOException {
            provider.defaultSerializeValue(GenotypeDocument.of(genotype), generator);
        }
    }

    private static final class Deserializer extends StdDeserializer<Genotype> {
        Deserializer() {
            super(Genotype.class);
        }

        @Override
        public Genotype deserialize(JsonParser parser, DeserializationContext context) throws IOException {
            try {
                return context.readValue(parser, GenotypeDocument.class).toGenotype();
            } catch (IllegalArgumentException e) {
                throw JsonMappingException.from(parser, e.getMessage(), e);
            }
        }
    }
}
