package mmneat.neat.io;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.MapperFeature;
import com.fasterxml.jackson.databind.json.JsonMapper;

/**
 * Settings for JSON files whose values count, such as genotypes and checkpoints. Reading refuses what Jackson would
 * otherwise repair or ignore: null instead of a number, numbers in quotation marks, fractions of whole numbers, fields
 * that occur twice, and text after the end.
 */
public final class StrictJson {

    private StrictJson() {}

    /** Returns a builder with these settings. */
    public static JsonMapper.Builder mapper() {
        return JsonMapper.builder()
                .enable(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES)
                .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
                .enable(JsonParser.Feature.STRICT_DUPLICATE_DETECTION)
                .disable(DeserializationFeature.ACCEPT_FLOAT_AS_INT)
                .disable(MapperFeature.ALLOW_COERCION_OF_SCALARS);
    }
}
