package mmneat.neat.io;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.io.JsonEOFException;
import com.fasterxml.jackson.databind.DeserializationContext;
import com.fasterxml.jackson.databind.JsonMappingException;
import com.fasterxml.jackson.databind.ObjectReader;
import com.fasterxml.jackson.databind.ObjectWriter;
import com.fasterxml.jackson.databind.SerializerProvider;
import com.fasterxml.jackson.databind.deser.std.StdDeserializer;
import com.fasterxml.jackson.databind.exc.MismatchedInputException;
import com.fasterxml.jackson.databind.exc.UnrecognizedPropertyException;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.module.SimpleModule;
import com.fasterxml.jackson.databind.ser.std.StdSerializer;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Collection;
import java.util.Locale;
import java.util.stream.Collectors;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;

/**
 * The JSON form of a genotype, described in docs/genotype-format.md.
 *
 * <p>Reading checks the format name and version, every field's presence and type, and that the genes form a network. An
 * error names the field. Numbers are written so that reading returns the same double.
 */
public final class GenotypeJson {

    /** Limits for documents, nesting and names; a genotype takes kilobytes. */
    private static final StreamReadConstraints LIMITS = StreamReadConstraints.builder()
            .maxNestingDepth(8)
            .maxDocumentLength(GenotypeFiles.MAX_BYTES)
            .maxStringLength(1_000)
            .maxNameLength(100)
            .maxNumberLength(100)
            .build();

    private static final JsonMapper MAPPER = mapper();
    private static final ObjectReader READER = MAPPER.readerFor(GenotypeDocument.class);
    private static final ObjectWriter WRITER = MAPPER.writer(new OneGenePerLine());

    private GenotypeJson() {}

    private static JsonMapper mapper() {
        JsonMapper mapper = StrictJson.mapper().build();
        mapper.getFactory().setStreamReadConstraints(LIMITS);
        return mapper;
    }

    /** Returns the JSON text of a genotype, with one gene per line. */
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
            requireThisVersion(json);
            GenotypeDocument document = READER.readValue(json);
            if (document == null) {
                throw new IllegalArgumentException("the JSON document is empty");
            }
            return document.toGenotype();
        } catch (JacksonException e) {
            throw new GenotypeFormatException(messageOf(e), e);
        } catch (IllegalArgumentException e) {
            throw new GenotypeFormatException(e.getMessage(), e);
        } catch (IOException e) {
            throw new UncheckedIOException("a text in memory cannot be read", e);
        }
    }

    /**
     * Returns the Jackson module that writes and reads genotypes in this form inside larger documents, such as
     * checkpoints.
     */
    public static SimpleModule module() {
        SimpleModule module = new SimpleModule("genotypes");
        module.addSerializer(new Serializer());
        module.addDeserializer(Genotype.class, new Deserializer());
        module.addSerializer(new FunctionSerializer());
        module.addDeserializer(ActivationFunction.class, new FunctionDeserializer());
        return module;
    }

    /**
     * Checks format and version before all other fields, because they decide how the others are read. A text that lacks
     * these two fields is reported when it is parsed.
     */
    private static void requireThisVersion(String json) throws IOException {
        try (JsonParser parser = MAPPER.createParser(json)) {
            boolean isFormatKnown = false;
            boolean isVersionKnown = false;
            JsonToken token = parser.nextToken();
            while (token == JsonToken.START_OBJECT
                    && !(isFormatKnown && isVersionKnown)
                    && parser.nextToken() == JsonToken.FIELD_NAME) {
                String field = parser.currentName();
                JsonToken value = parser.nextToken();
                if (field.equals("format") && value == JsonToken.VALUE_STRING) {
                    GenotypeDocument.requireFormat(parser.getText());
                    isFormatKnown = true;
                } else if (field.equals("version") && value == JsonToken.VALUE_NUMBER_INT) {
                    GenotypeDocument.requireVersion(parser.getIntValue());
                    isVersionKnown = true;
                } else {
                    parser.skipChildren();
                }
            }
            if (parser.currentToken() == JsonToken.END_OBJECT && !isFormatKnown) {
                throw new IllegalArgumentException("format: is missing; a genotype has \"format\" : \""
                        + GenotypeDocument.FORMAT + "\" and \"version\" : " + GenotypeDocument.VERSION);
            }
        }
    }

    /** Returns one line: the field, what is wrong, and the position in the text. */
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
        return (field.isEmpty() ? "" : field.substring(field.startsWith(".") ? 1 : 0) + ": ") + problemOf(e) + where;
    }

    private static String problemOf(JacksonException e) {
        if (e instanceof UnrecognizedPropertyException) {
            return "unknown field";
        }
        if (e instanceof JsonEOFException || e.getCause() instanceof JsonEOFException) {
            return "the file ends too early";
        }
        String what = e.getOriginalMessage().lines().findFirst().orElse("not a genotype");
        if (what.startsWith("Missing required")) {
            return "is missing";
        }
        if (e instanceof MismatchedInputException mismatch && mismatch.getTargetType() != null) {
            return "must be " + nameOf(mismatch.getTargetType());
        }
        // The parser's message continues with its own settings and the position a second time.
        return what.replaceAll(
                ": enable .*| \\(start marker at .*| \\(not recognized as one since .*| \\[Source: .*", "");
    }

    private static String nameOf(Class<?> type) {
        if (type == int.class || type == long.class) {
            return "a whole number" + (type == int.class ? " of at most " + Integer.MAX_VALUE : "");
        }
        if (type == double.class) {
            return "a number";
        }
        if (type == boolean.class || type == Boolean.class) {
            return "true or false";
        }
        if (type == String.class) {
            return "a text in quotation marks";
        }
        return type.isArray() || Collection.class.isAssignableFrom(type) ? "a list" : "an object";
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

    /** Writes the activation function of an archetype's entry: built-in ones in upper case. */
    private static final class FunctionSerializer extends StdSerializer<ActivationFunction> {
        FunctionSerializer() {
            super(ActivationFunction.class);
        }

        @Override
        public void serialize(ActivationFunction function, JsonGenerator generator, SerializerProvider provider)
                throws IOException {
            String text = FunctionNames.of(function);
            generator.writeString(function.isOwn() ? text : text.toUpperCase(Locale.ROOT));
        }
    }

    private static final class FunctionDeserializer extends StdDeserializer<ActivationFunction> {
        FunctionDeserializer() {
            super(ActivationFunction.class);
        }

        @Override
        public ActivationFunction deserialize(JsonParser parser, DeserializationContext context) throws IOException {
            String text = context.readValue(parser, String.class);
            try {
                return FunctionNames.read(FunctionNames.isOwn(text) ? text : text.toLowerCase(Locale.ROOT));
            } catch (IllegalArgumentException e) {
                throw JsonMappingException.from(parser, e.getMessage(), e);
            }
        }
    }
}
