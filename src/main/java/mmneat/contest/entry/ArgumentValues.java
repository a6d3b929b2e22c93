package mmneat.contest.entry;

import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.function.Supplier;

/** Converts the texts of a constructor's arguments to values: numbers, booleans, texts, enum constants, controllers. */
final class ArgumentValues {

    /** The conversions by type, ranked from the most to the least specific type. */
    private static final Map<Class<?>, Conversion> CONVERSIONS = Map.ofEntries(
            Map.entry(boolean.class, new Conversion(1, ArgumentValues::booleanOf)),
            Map.entry(int.class, new Conversion(2, Integer::valueOf)),
            Map.entry(long.class, new Conversion(3, Long::valueOf)),
            Map.entry(short.class, new Conversion(4, Short::valueOf)),
            Map.entry(byte.class, new Conversion(5, Byte::valueOf)),
            Map.entry(double.class, new Conversion(6, Double::valueOf)),
            Map.entry(float.class, new Conversion(7, Float::valueOf)),
            Map.entry(char.class, new Conversion(8, ArgumentValues::charOf)),
            Map.entry(String.class, new Conversion(9, ArgumentValues::unquoted)));

    private static final Map<Class<?>, Class<?>> PRIMITIVES = Map.of(
            Boolean.class, boolean.class,
            Integer.class, int.class,
            Long.class, long.class,
            Short.class, short.class,
            Byte.class, byte.class,
            Double.class, double.class,
            Float.class, float.class,
            Character.class, char.class);

    /**
     * @param rank the lower, the better the type fits a text
     * @param value throws IllegalArgumentException if the text is not of the type
     */
    private record Conversion(int rank, Function<String, Object> value) {}

    /**
     * The finder of controllers that are constructor arguments of another controller. For example, in {@code
     * my.Entry(Legacy,3)} the first argument may be the ghosts' controller {@code Legacy}.
     */
    interface Controllers {
        /**
         * Returns a factory of the controllers that a call describes; empty if there is no such class or it is not of
         * this type.
         */
        Optional<Supplier<?>> find(String call, Class<?> type);
    }

    /**
     * A value for a parameter, created again for each controller.
     *
     * @param rank the lower, the better the parameter fits the text
     */
    record Argument(int rank, Supplier<?> value) {}

    private final Controllers controllers;

    ArgumentValues(Controllers controllers) {
        this.controllers = controllers;
    }

    /** Returns the value of a text for a parameter; empty if the text cannot be converted to the parameter's type. */
    Optional<Argument> of(String text, Class<?> parameter) {
        Class<?> type = PRIMITIVES.getOrDefault(parameter, parameter);
        Conversion conversion = CONVERSIONS.get(type);
        if (conversion != null) {
            return convert(text, conversion).map(value -> new Argument(conversion.rank(), () -> value));
        }
        if (type.isEnum()) {
            return Arrays.stream(type.getEnumConstants())
                    .filter(constant -> ((Enum<?>) constant).name().equals(unquoted(text)))
                    .findFirst()
                    .map(constant -> new Argument(0, () -> constant));
        }
        return controllers.find(text, type).map(value -> new Argument(0, value));
    }

    private static Optional<Object> convert(String text, Conversion conversion) {
        try {
            return Optional.of(conversion.value().apply(text));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    private static Object booleanOf(String text) {
        if (text.equals("true") || text.equals("false")) {
            return Boolean.valueOf(text);
        }
        throw new IllegalArgumentException(text);
    }

    private static Object charOf(String text) {
        OptionalInt only = unquoted(text).chars().reduce((first, second) -> -1);
        if (only.isEmpty() || only.getAsInt() < 0) {
            throw new IllegalArgumentException(text);
        }
        return (char) only.getAsInt();
    }

    private static String unquoted(String text) {
        boolean isQuoted = text.length() >= 2
                && (text.startsWith("'") || text.startsWith("\""))
                && text.charAt(0) == text.charAt(text.length() - 1);
        return isQuoted ? text.substring(1, text.length() - 1) : text;
    }
}
