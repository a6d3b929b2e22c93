package mmneat.experiment.parameters;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * The allowed values of a parameter: a range of numbers, a choice of words, or any value.
 *
 * @param minimum the smallest number; minus infinity if there is none
 * @param maximum the largest number; infinity if there is none
 * @param choices the allowed words; empty if every text is allowed
 * @param extension what else the value may be, besides the choices
 */
record AllowedValues(double minimum, double maximum, List<String> choices, Extension extension) {

    /** The kind of values that are allowed besides the listed choices. */
    enum Extension {
        /** Only the listed choices. */
        NONE(""),
        /** Also the name of a class of the user's own. */
        OWN_CLASS("<class>"),
        /** Also the short name of a hybrid method, such as {@code H21}. */
        HYBRID("<hybrid>");

        /** The last word of the list in the catalogue that stands for this kind. */
        private final String mark;

        Extension(String mark) {
            this.mark = mark;
        }

        boolean permits(String value) {
            return switch (this) {
                case NONE -> false;
                case OWN_CLASS -> OwnClasses.isName(value);
                case HYBRID -> HybridMethod.of(value).isPresent();
            };
        }

        private String words() {
            return switch (this) {
                case NONE -> "";
                case OWN_CLASS -> ", or a class of your own";
                case HYBRID -> ", or a hybrid such as H21";
            };
        }
    }

    private static final AllowedValues ANYTHING =
            new AllowedValues(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, List.of(), Extension.NONE);

    AllowedValues {
        choices = List.copyOf(choices);
    }

    /**
     * Reads the catalogue's form: {@code 0..1}, {@code 1..}, {@code red|green}, {@code red|green|<class>}, or nothing.
     */
    static AllowedValues of(String text) {
        if (text.isEmpty()) {
            return ANYTHING;
        }
        int dots = text.indexOf("..");
        if (dots < 0) {
            List<String> words = List.of(text.split("\\|"));
            Extension extension = Arrays.stream(Extension.values())
                    .filter(each -> words.contains(each.mark))
                    .findFirst()
                    .orElse(Extension.NONE);
            return new AllowedValues(
                    ANYTHING.minimum,
                    ANYTHING.maximum,
                    words.stream().filter(word -> !word.equals(extension.mark)).toList(),
                    extension);
        }
        String last = text.substring(dots + 2);
        return new AllowedValues(
                Double.parseDouble(text.substring(0, dots)),
                last.isEmpty() ? Double.POSITIVE_INFINITY : Double.parseDouble(last),
                List.of(),
                Extension.NONE);
    }

    /** Returns the choice or hybrid that equals the text except for case; the text itself if there is none. */
    String spelled(String text) {
        String upper = text.toUpperCase(Locale.ROOT);
        String other = extension == Extension.HYBRID && extension.permits(upper) ? upper : text;
        return choices.stream().filter(text::equalsIgnoreCase).findFirst().orElse(other);
    }

    boolean permits(ParameterType type, String canonical) {
        if (!choices.isEmpty()) {
            return choices.contains(canonical) || extension.permits(canonical);
        }
        if (type == ParameterType.DOUBLE || type == ParameterType.INTEGER || type == ParameterType.LONG) {
            double value = Double.parseDouble(canonical);
            return value >= minimum && value <= maximum && Double.isFinite(value);
        }
        return true;
    }

    /** Returns a description of the allowed values that follows the words "must be". */
    String describe(ParameterType type) {
        if (!choices.isEmpty()) {
            String words = choices.size() == 1 ? choices.get(0) : "one of " + String.join(", ", choices);
            return words + extension.words();
        }
        if (minimum == Double.NEGATIVE_INFINITY && maximum == Double.POSITIVE_INFINITY) {
            return type.description();
        }
        if (maximum == Double.POSITIVE_INFINITY) {
            return type.description() + ", at least " + number(type, minimum);
        }
        return type.description() + " from " + number(type, minimum) + " to " + number(type, maximum);
    }

    /** As {@link #describe(ParameterType)}, with both limits if the text is a whole number beyond those of the type. */
    String describe(ParameterType type, String text) {
        if (!type.isTooLarge(text)) {
            return describe(type);
        }
        return type.description() + " from " + number(type, Math.max(minimum, type.smallest())) + " to "
                + number(type, Math.min(maximum, type.largest()));
    }

    private static String number(ParameterType type, double value) {
        return type == ParameterType.DOUBLE ? Double.toString(value) : Long.toString((long) value);
    }
}
