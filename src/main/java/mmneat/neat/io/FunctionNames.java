package mmneat.neat.io;

import java.util.stream.Collectors;
import mmneat.neat.ActivationFunction;

/** The texts of activation functions in files: the names of built-in ones, {@code class:NAME} for others. */
final class FunctionNames {

    private static final String CLASS = "class:";

    private FunctionNames() {}

    static String of(ActivationFunction function) {
        return (function.isOwn() ? CLASS : "") + function.name();
    }

    /** Whether a text stands for a function of the user's own. */
    static boolean isOwn(String text) {
        return text.startsWith(CLASS);
    }

    /**
     * Returns the function of a text. One of the user's own is not bound, because a file brings no code along.
     *
     * @throws IllegalArgumentException if there is none; the message says what is allowed
     */
    static ActivationFunction read(String text) {
        if (text != null && isOwn(text)) {
            return ActivationFunction.ofClass(text.substring(CLASS.length()));
        }
        return ActivationFunction.builtIn().stream()
                .filter(function -> function.name().equals(text))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("must be one of "
                        + ActivationFunction.builtIn().stream()
                                .map(ActivationFunction::name)
                                .collect(Collectors.joining(", "))
                        + ", or " + CLASS + " and the name of a class, is \"" + text + "\""));
    }
}
