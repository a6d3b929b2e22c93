package mmneat.experiment;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.core.exc.StreamConstraintsException;
import com.fasterxml.jackson.core.io.JsonEOFException;
import com.fasterxml.jackson.databind.JsonMappingException;
import com.fasterxml.jackson.databind.exc.MismatchedInputException;
import com.fasterxml.jackson.databind.exc.UnrecognizedPropertyException;
import com.fasterxml.jackson.databind.exc.ValueInstantiationException;
import java.util.regex.Pattern;

/**
 * Converter of exceptions about JSON files to messages for the user. The messages of the JSON library are not readable
 * for users: they contain names of Java classes and of settings of the library.
 */
public final class JsonProblem {

    private static final String NO_JSON = "it is not JSON";

    /** How the part of a message begins that speaks of the library's settings and classes. */
    private static final Pattern OF_THE_LIBRARY =
            Pattern.compile("(: enable `| \\(start marker| \\(not recognized as one since| ?\\[Source:).*");

    /** Quoted code, or a qualified name. */
    private static final Pattern JAVA = Pattern.compile("`|[a-z]\\.[A-Za-z]");

    private JsonProblem() {}

    /** Returns what is wrong in the file, on one line. */
    public static String of(JacksonException e) {
        if (e.getCause() instanceof NullPointerException) {
            return "a part of it is null";
        }
        if (e instanceof UnrecognizedPropertyException unknown) {
            return "unknown field '" + unknown.getPropertyName() + "'";
        }
        if (e instanceof ValueInstantiationException refused && refused.getCause() != null) {
            return String.valueOf(refused.getCause().getMessage());
        }
        if (e instanceof JsonEOFException || e.getCause() instanceof JsonEOFException) {
            return "the file ends too early";
        }
        if (e.getCause() instanceof StreamConstraintsException || e instanceof StreamConstraintsException) {
            return "it is nested too deeply, or a number or name in it is too long";
        }
        String message = e.getOriginalMessage().lines().findFirst().orElse(NO_JSON);
        if (message.startsWith("No content to map")) {
            return "the file is empty";
        }
        if (e instanceof MismatchedInputException mismatch && message.contains("`")) {
            return (mismatch.getPath().isEmpty() ? "it" : field(mismatch)) + " has a value of the wrong type";
        }
        // The parser's message continues with its own settings.
        String plain = OF_THE_LIBRARY.matcher(message).replaceFirst("");
        return JAVA.matcher(plain).find() ? NO_JSON : plain;
    }

    /** Returns the field's place, such as evolution.population[2].id. */
    private static String field(JsonMappingException e) {
        StringBuilder place = new StringBuilder();
        e.getPath().forEach(step -> {
            if (step.getFieldName() == null) {
                place.append('[').append(step.getIndex()).append(']');
            } else {
                place.append(place.length() == 0 ? "" : ".").append(step.getFieldName());
            }
        });
        return place.toString();
    }
}
