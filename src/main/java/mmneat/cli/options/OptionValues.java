package mmneat.cli.options;

import java.lang.reflect.AnnotatedElement;
import java.math.BigInteger;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.StreamSupport;
import mmneat.experiment.NearestName;
import mmneat.experiment.UserError;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.TypeConversionException;

/**
 * Parsing and checking of option values, and the messages for values that are not allowed.
 *
 * <p>Numbers have a {@link Range}. Options of type String with completion candidates accept these values only, in upper
 * or lower case.
 */
public final class OptionValues {

    private OptionValues() {}

    /** Registers the parsers of values. */
    public static void register(CommandLine line) {
        line.registerConverter(Integer.class, text -> Integer.valueOf(digits(text)));
        line.registerConverter(int.class, text -> Integer.valueOf(digits(text)));
        line.registerConverter(Long.class, text -> Long.valueOf(digits(text)));
        line.registerConverter(long.class, text -> Long.valueOf(digits(text)));
        line.registerConverter(Boolean.class, OptionValues::flag);
        line.registerConverter(boolean.class, OptionValues::flag);
        line.registerConverter(Path.class, OptionValues::path);
    }

    private static String digits(String text) {
        return text.strip().replace("_", "");
    }

    private static Boolean flag(String text) {
        return switch (text.strip().toLowerCase(Locale.ROOT)) {
            case "true" -> true;
            case "false" -> false;
            default -> throw new TypeConversionException("not true or false");
        };
    }

    /** @throws TypeConversionException if the text is blank or cannot be a file name */
    static Path path(String text) {
        if (text.isBlank()) {
            throw new TypeConversionException("no name");
        }
        try {
            return Path.of(text);
        } catch (InvalidPathException e) {
            throw new TypeConversionException(e.getMessage());
        }
    }

    /**
     * Checks the values of a command against their ranges and choices, and gives choices the case in which they are
     * declared.
     *
     * @throws UserError if a value is not allowed
     */
    public static void check(ParseResult command) {
        for (OptionSpec option : command.matchedOptions()) {
            String text = option.originalStringValues().isEmpty()
                    ? ""
                    : option.originalStringValues().get(0);
            List<String> choices = choices(option);
            if (!choices.isEmpty() && option.type() == String.class) {
                option.setValue(choices.stream()
                        .filter(text.strip()::equalsIgnoreCase)
                        .findFirst()
                        .orElseThrow(() -> badValue(option, text)));
            }
            Optional<Range> range = range(option);
            if (range.isPresent() && option.getValue() instanceof Number number) {
                long value = number.longValue();
                if (value < range.get().min() || value > range.get().max()) {
                    throw badValue(option, text);
                }
            }
        }
    }

    /** Returns the error of an option's value; empty if picocli refused the arguments for another reason. */
    public static Optional<UserError> refusal(ParameterException mistake) {
        if (mistake.getCause() instanceof UserError error) {
            return Optional.of(error);
        }
        boolean isAboutValue = mistake.getArgSpec() instanceof OptionSpec && mistake.getValue() != null;
        return isAboutValue ? Optional.of(badValue(mistake.getArgSpec(), mistake.getValue())) : Optional.empty();
    }

    private static UserError badValue(ArgSpec option, String text) {
        return badValue(((OptionSpec) option).longestName(), text, allowed(option, text));
    }

    /** Returns the error for a value that is not allowed. */
    public static UserError badValue(String name, String value, String allowed) {
        return new UserError(name + "=" + value + ": must be " + allowed);
    }

    private static String allowed(ArgSpec option, String text) {
        Class<?> type = option.type();
        if (!choices(option).isEmpty()) {
            return oneOf(choices(option), text);
        }
        if (type == Boolean.class || type == boolean.class) {
            return "true or false";
        }
        if (type == Path.class) {
            return "the name of a file or folder";
        }
        String number = digits(text);
        if (number.matches("[+-]?\\d+")) {
            boolean isInt = type == Integer.class || type == int.class;
            long smallest = range(option).map(Range::min).orElse(isInt ? Integer.MIN_VALUE : Long.MIN_VALUE);
            long largest = range(option).map(Range::max).orElse(isInt ? Integer.MAX_VALUE : Long.MAX_VALUE);
            if (new BigInteger(number).compareTo(BigInteger.valueOf(largest)) > 0
                    || range(option).isEmpty()) {
                return "a whole number from " + smallest + " to " + largest;
            }
        }
        return range(option).map(OptionValues::inWords).orElse("a whole number");
    }

    private static String oneOf(List<String> choices, String text) {
        return "one of " + String.join(", ", choices) + NearestName.suggestion(text, choices);
    }

    private static String inWords(Range range) {
        return range.max() >= Integer.MAX_VALUE
                ? "a whole number, at least " + range.min()
                : "a whole number from " + range.min() + " to " + range.max();
    }

    private static List<String> choices(ArgSpec option) {
        return option.completionCandidates() == null
                ? List.of()
                : StreamSupport.stream(option.completionCandidates().spliterator(), false)
                        .toList();
    }

    private static Optional<Range> range(ArgSpec option) {
        return option.userObject() instanceof AnnotatedElement field
                ? Optional.ofNullable(field.getAnnotation(Range.class))
                : Optional.empty();
    }

    /** Whether an option was given to a command. */
    public static boolean isGiven(CommandSpec command, String option) {
        return command.commandLine().getParseResult().hasMatchedOption(option);
    }

    /**
     * Refuses an option where it has no effect.
     *
     * @param hasEffect whether it has an effect
     * @param reason what the option needs, for the message
     * @throws UserError if the option was given and has no effect
     */
    public static void requireEffect(CommandSpec command, String option, boolean hasEffect, String reason) {
        if (!hasEffect && isGiven(command, option)) {
            String value = command.findOption(option).originalStringValues().get(0);
            throw new UserError(option + "=" + value + " has no effect here: " + reason + "; leave it out");
        }
    }
}
