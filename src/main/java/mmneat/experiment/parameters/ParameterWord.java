package mmneat.experiment.parameters;

import java.util.Optional;
import mmneat.experiment.UserError;

/**
 * One argument: a name and a value, in one of two forms. Which one is decided by the sign that comes first.
 *
 * <ul>
 *   <li>{@code name=value}: everything behind the sign is the value, nothing at all included.
 *   <li>{@code name:value}, the original's: split at colons, and of the pieces that are not empty the first two count;
 *       booleans are true for "true" and false for anything else.
 * </ul>
 *
 * Source: docs/specification/evolution.md, section 4.1.
 *
 * @param name what stands before the sign
 * @param value what stands behind it
 * @param originalForm whether it was written with a colon
 */
record ParameterWord(String name, String value, boolean originalForm) {

    static ParameterWord parse(String word) {
        int equalsSign = word.indexOf('=');
        int colon = word.indexOf(':');
        if (equalsSign < 0 && colon < 0) {
            throw new UserError("'" + word + "' is not understood; parameters are written name=value");
        }
        boolean originalForm = colon >= 0 && (equalsSign < 0 || colon < equalsSign);
        ParameterWord parsed = originalForm
                ? original(word)
                : new ParameterWord(word.substring(0, equalsSign), word.substring(equalsSign + 1), false);
        Optional<String> counterpart = OriginalCounterparts.ofMode(parsed.name, parsed.value);
        if (counterpart.isPresent()) {
            throw new UserError("'" + word + "' is a mode of the original; here, " + counterpart.get());
        }
        if (originalForm && parsed.value.isEmpty()) {
            throw new UserError("'" + word + "' has no value; write " + parsed.name + "= for an empty one");
        }
        return parsed;
    }

    /** The original's rule alone; a missing value is the empty text, which only its files allow. */
    static ParameterWord original(String word) {
        String name = "";
        for (String piece : word.split(":")) {
            if (piece.isEmpty()) {
                continue;
            }
            if (!name.isEmpty()) {
                return new ParameterWord(name, piece, true);
            }
            name = piece;
        }
        return new ParameterWord(name, "", true);
    }

    /** The value as the parameter's type reads it in this form. */
    String canonicalFor(Parameter parameter) {
        if (originalForm && parameter.type() == ParameterType.BOOLEAN) {
            return parameter.check(Boolean.toString(value.equalsIgnoreCase("true")));
        }
        return parameter.check(value);
    }

    /** Whether the original's form made something else of the value than its writer may have meant. */
    boolean isMisleading(Parameter parameter) {
        return originalForm
                && parameter.type() == ParameterType.BOOLEAN
                && !value.equalsIgnoreCase("true")
                && !value.equalsIgnoreCase("false");
    }
}
