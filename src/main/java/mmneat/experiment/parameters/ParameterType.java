package mmneat.experiment.parameters;

import java.util.Locale;
import mmneat.experiment.PlainText;
import mmneat.mspacman.modules.OriginalClassName;

/** The kinds of values that parameters have. */
public enum ParameterType {
    /** A whole number of 32 bits. */
    INTEGER("a whole number"),
    /** A whole number of 64 bits. */
    LONG("a whole number"),
    /** {@code true} or {@code false}. */
    BOOLEAN("true or false"),
    /** A floating-point number of 64 bits. */
    DOUBLE("a number"),
    /** Any text on one line. */
    TEXT("any text"),
    /** The name of a class, of the original (with or without its package) or of the user's own. */
    CLASS("the name of a class");

    private final String description;

    ParameterType(String description) {
        this.description = description;
    }

    /** Returns a description of this type that follows the words "must be". */
    String description() {
        return description;
    }

    /**
     * Returns the canonical form of a value: equal values have equal texts.
     *
     * @throws IllegalArgumentException if the text is not a value of this type
     */
    String canonical(String text) {
        return switch (this) {
            case INTEGER -> Integer.toString(Integer.parseInt(text));
            case LONG -> Long.toString(Long.parseLong(text));
            case BOOLEAN -> canonicalBoolean(text);
            case DOUBLE -> Double.toString(Double.parseDouble(text.strip()));
            case TEXT -> PlainText.trimmed(text);
            case CLASS -> canonicalClass(text);
        };
    }

    /** Whether a text is a whole number, but too small or too large for this type. */
    boolean isTooLarge(String text) {
        if (!(this == INTEGER || this == LONG) || !text.matches("[+-]?\\d+")) {
            return false;
        }
        double value = Double.parseDouble(text);
        return value < smallest() || value > largest();
    }

    /** The smallest value of a type of whole numbers. */
    long smallest() {
        return this == INTEGER ? Integer.MIN_VALUE : Long.MIN_VALUE;
    }

    /** The largest value of a type of whole numbers. */
    long largest() {
        return this == INTEGER ? Integer.MAX_VALUE : Long.MAX_VALUE;
    }

    private static String canonicalBoolean(String text) {
        String lower = text.strip().toLowerCase(Locale.ROOT);
        if (!lower.equals("true") && !lower.equals("false")) {
            throw new IllegalArgumentException("neither true nor false: " + text);
        }
        return lower;
    }

    /** Returns the simple name of a class of the original, whichever package is given. */
    private static String canonicalClass(String text) {
        String name = text.strip();
        return name.equals("null") ? "" : OriginalClassName.simple(name);
    }

    static ParameterType of(String name) {
        return valueOf(name.toUpperCase(Locale.ROOT));
    }

    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
