package mmneat.cli;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import mmneat.experiment.NearestName;
import mmneat.experiment.UserError;

/**
 * The arguments of a command: words {@code name=value} or {@code name:value} (the form of the original), and, where the
 * command allows them, plain words such as file names.
 *
 * <p>An unknown name, a name given twice or a value that does not fit is a {@link UserError} that names the word and
 * says what is allowed.
 */
public final class Words {

    /** A name is letters, digits, dots, dashes and underscores; the first sign after it ends it. */
    private static final Pattern NAMED = Pattern.compile("([A-Za-z][A-Za-z0-9._-]*)[=:](.*)", Pattern.DOTALL);

    private final Map<String, String> values;
    private final List<String> plain;

    private Words(Map<String, String> values, List<String> plain) {
        this.values = values;
        this.plain = plain;
    }

    /** Reads words that must all be {@code name=value} with a known name. */
    public static Words parse(Collection<String> words, Collection<String> knownNames) {
        return parse(words, knownNames, 0);
    }

    /**
     * Reads words.
     *
     * @param knownNames the names that may stand before the sign
     * @param plainWords how many words without a name there may be at most, for instance file names
     */
    public static Words parse(Collection<String> words, Collection<String> knownNames, int plainWords) {
        Map<String, String> values = new LinkedHashMap<>();
        List<String> plain = new ArrayList<>();
        for (String word : words) {
            Matcher named = NAMED.matcher(word);
            boolean known = named.matches() && knownNames.contains(named.group(1));
            if (known) {
                if (values.putIfAbsent(named.group(1), named.group(2)) != null) {
                    throw new UserError("'" + named.group(1) + "' is given twice; give it once");
                }
            } else if (plain.size() < plainWords && !(named.matches() && word.charAt(named.end(1)) == '=')) {
                // A plain word may contain a colon (a drive letter, a time), but not look like an assignment.
                plain.add(word);
            } else if (knownNames.contains(word)) {
                throw new UserError("'" + word + "' has no value; write " + word + "=...");
            } else if (named.matches()) {
                throw unknown(named.group(1), knownNames);
            } else {
                throw new UserError("'" + word + "' is not understood; write name=value"
                        + NearestName.suggestion(word, knownNames));
            }
        }
        return new Words(values, plain);
    }

    private static UserError unknown(String name, Collection<String> knownNames) {
        String suggestion = NearestName.suggestion(name, knownNames);
        return new UserError("unknown name '" + name + "'"
                + (suggestion.isEmpty() ? "; known: " + String.join(", ", knownNames) : suggestion));
    }

    /** The words without a name, in their order. */
    public List<String> plain() {
        return List.copyOf(plain);
    }

    /** All words with a name, in their order. */
    public Map<String, String> named() {
        return new LinkedHashMap<>(values);
    }

    /** Whether the name was given. */
    public boolean has(String name) {
        return values.containsKey(name);
    }

    /** The value as typed; empty if the name was not given. */
    public Optional<String> text(String name) {
        return Optional.ofNullable(values.get(name));
    }

    /** The value as typed, or {@code otherwise}. */
    public String text(String name, String otherwise) {
        return values.getOrDefault(name, otherwise);
    }

    /** The value as typed; an error that shows {@code example} if it was not given. */
    public String requiredText(String name, String example) {
        return text(name)
                .orElseThrow(() -> new UserError("'" + name + "' is missing; give it as " + name + "=" + example));
    }

    /** A file or folder; empty if the name was not given. Whether it exists is not asked here. */
    public Optional<Path> path(String name) {
        return text(name).map(text -> {
            try {
                if (text.isBlank()) {
                    throw badValue(name, text, "the name of a file or folder");
                }
                return Path.of(text);
            } catch (InvalidPathException e) {
                throw badValue(name, text, "the name of a file or folder");
            }
        });
    }

    /** A whole number in [{@code minimum}, {@code maximum}], or {@code otherwise} if the name was not given. */
    public int integer(String name, int otherwise, int minimum, int maximum) {
        return (int) longInteger(name, otherwise, minimum, maximum);
    }

    /** A whole number in [{@code minimum}, {@code maximum}], or {@code otherwise} if the name was not given. */
    public long longInteger(String name, long otherwise, long minimum, long maximum) {
        if (!has(name)) {
            return otherwise;
        }
        String text = values.get(name).strip();
        String allowed = minimum == Long.MIN_VALUE && maximum == Long.MAX_VALUE
                ? "a whole number"
                : maximum == Integer.MAX_VALUE || maximum == Long.MAX_VALUE
                        ? "a whole number, at least " + minimum
                        : "a whole number from " + minimum + " to " + maximum;
        try {
            long value = Long.parseLong(text.replace("_", ""));
            if (value < minimum || value > maximum) {
                throw badValue(name, text, allowed);
            }
            return value;
        } catch (NumberFormatException e) {
            throw badValue(name, text, allowed);
        }
    }

    /** A finite number in [{@code minimum}, {@code maximum}], or {@code otherwise} if the name was not given. */
    public double number(String name, double otherwise, double minimum, double maximum) {
        if (!has(name)) {
            return otherwise;
        }
        String text = values.get(name).strip();
        String allowed = "a number from " + minimum + " to " + maximum;
        try {
            double value = Double.parseDouble(text);
            if (!Double.isFinite(value) || value < minimum || value > maximum) {
                throw badValue(name, text, allowed);
            }
            return value;
        } catch (NumberFormatException e) {
            throw badValue(name, text, allowed);
        }
    }

    /** {@code true} or {@code false}, or {@code otherwise} if the name was not given. */
    public boolean flag(String name, boolean otherwise) {
        if (!has(name)) {
            return otherwise;
        }
        String text = values.get(name).strip();
        return switch (text.toLowerCase(Locale.ROOT)) {
            case "true" -> true;
            case "false" -> false;
            default -> throw badValue(name, text, "true or false");
        };
    }

    /** One of {@code choices}, upper and lower case being the same; or {@code otherwise} if the name was not given. */
    public String choice(String name, String otherwise, Collection<String> choices) {
        if (!has(name)) {
            return otherwise;
        }
        String text = values.get(name).strip();
        return choices.stream().filter(text::equalsIgnoreCase).findFirst().orElseThrow(() -> {
            String allowed = "one of " + String.join(", ", choices);
            return badValue(name, text, allowed + NearestName.suggestion(text, choices));
        });
    }

    /**
     * Makes sure that a word is not given where it has no effect.
     *
     * @param hasEffect whether it has one
     * @param reason what it goes with, for the message
     */
    public void requireEffect(String name, boolean hasEffect, String reason) {
        if (has(name) && !hasEffect) {
            throw new UserError(name + "=" + values.get(name) + " has no effect here: " + reason + "; leave it out");
        }
    }

    /** The error for a value that does not fit: names the word and says what is allowed. */
    public static UserError badValue(String name, String value, String allowed) {
        return new UserError(name + "=" + value + ": must be " + allowed);
    }
}
