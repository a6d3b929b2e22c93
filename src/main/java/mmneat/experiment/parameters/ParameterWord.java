package mmneat.experiment.parameters;

import java.util.Optional;
import mmneat.experiment.UserError;

/**
 * One argument of the command line: a name and a value, in one of two forms. The first separator decides which.
 *
 * <ul>
 *   <li>{@code name=value}: all text after the first {@code =} is the value. The value may be empty.
 *   <li>{@code name:value}, the original's: split at colons, and of the pieces that are not empty the first two count;
 *       booleans are true for "true" and false for anything else.
 * </ul>
 *
 * Source: docs/specification/evolution.md, section 4.1.
 *
 * @param name the text before the separator
 * @param value the text after it
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

    /** Applies the original's rule. A missing value is the empty text, which only the original's files allow. */
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

    /** Returns the canonical value of the parameter, read by the rules of this form. */
    String canonicalFor(Parameter parameter) {
        if (originalForm && parameter.type() == ParameterType.BOOLEAN) {
            return parameter.check(Boolean.toString(value.equalsIgnoreCase("true")));
        }
        return parameter.check(value);
    }

    /** Whether the original's form may have changed the intended value. */
    boolean isMisleading(Parameter parameter) {
        return originalForm
                && parameter.type() == ParameterType.BOOLEAN
                && !value.equalsIgnoreCase("true")
                && !value.equalsIgnoreCase("false");
    }
}
