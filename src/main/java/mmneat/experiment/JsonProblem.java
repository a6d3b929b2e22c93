package mmneat.experiment;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.databind.JsonMappingException;
import com.fasterxml.jackson.databind.exc.MismatchedInputException;
import com.fasterxml.jackson.databind.exc.UnrecognizedPropertyException;
import com.fasterxml.jackson.databind.exc.ValueInstantiationException;

/**
 * Converter of exceptions about JSON files to messages for the user. The messages of the JSON library are not readable
 * for users: they contain names of Java classes and of settings of the library.
 */
public final class JsonProblem {

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
        String message = e.getOriginalMessage().lines().findFirst().orElse("it is not JSON");
        if (e instanceof MismatchedInputException mismatch && message.contains("`")) {
            return (mismatch.getPath().isEmpty() ? "it" : field(mismatch)) + " has a value of the wrong type";
        }
        // The parser's message continues with its own settings.
        return message.replaceFirst(": enable `.*", "");
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
