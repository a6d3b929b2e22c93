package mmneat.neat;

import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * The function that turns a neuron's sum into its activation: one of five built-in ones, which {@code
 * mmneat.neat.network} computes, or a class of the user's own.
 *
 * <p>A function of the user's own is known by the name of its class; two with one name are equal. Files of networks
 * contain this name alone. A network that was read from a file is therefore not {@linkplain #isBound bound}: it can be
 * drawn, converted and changed, and it is activated after {@link Genotype#withFunctions} has put in the object.
 *
 * <p>Source: docs/specification/networks.md, section 5.3.
 */
public final class ActivationFunction {

    /** 1 / (1 + e(-x)), the exponent clamped to [-7, 7]. */
    public static final ActivationFunction LOGISTIC = new ActivationFunction(0, "logistic", null);

    /** Hyperbolic tangent: the function of all published experiments. */
    public static final ActivationFunction TANH = new ActivationFunction(1, "tanh", null);

    /** The sum itself. */
    public static final ActivationFunction IDENTITY = new ActivationFunction(2, "identity", null);

    /** The approximate logistic function, stretched to (-1, 1). */
    public static final ActivationFunction APPROXIMATE_TANH = new ActivationFunction(3, "approximate_tanh", null);

    /** The logistic function with an exponential made of the bits of a double. */
    public static final ActivationFunction APPROXIMATE_LOGISTIC =
            new ActivationFunction(4, "approximate_logistic", null);

    private static final List<ActivationFunction> BUILT_IN =
            List.of(LOGISTIC, TANH, IDENTITY, APPROXIMATE_TANH, APPROXIMATE_LOGISTIC);

    private static final int OWN = -1;

    private final int code;
    private final String name;

    /** Null if it is built-in or its class has not been loaded. */
    private final @Nullable NeuronFunction function;

    private ActivationFunction(int code, String name, @Nullable NeuronFunction function) {
        this.code = code;
        this.name = name;
        this.function = function;
    }

    /** The built-in functions in the order of their codes. */
    public static List<ActivationFunction> builtIn() {
        return BUILT_IN;
    }

    /**
     * The built-in function with the original's code.
     *
     * @throws IllegalArgumentException if no function has this code
     */
    public static ActivationFunction ofCode(int code) {
        if (code < 0 || code >= BUILT_IN.size()) {
            throw new IllegalArgumentException("activation function must be 0 to 4, is " + code);
        }
        return BUILT_IN.get(code);
    }

    /**
     * A function of the user's own, named after the class of the object.
     *
     * @throws IllegalArgumentException if the object is a lambda expression, whose class has no lasting name
     */
    public static ActivationFunction own(NeuronFunction function) {
        return own(function.getClass().getName(), function);
    }

    /**
     * A function of the user's own with another name, such as a lambda expression.
     *
     * @param name the name in files of networks, in the form of a class's name
     * @throws IllegalArgumentException if it does not have this form
     */
    public static ActivationFunction own(String name, NeuronFunction function) {
        return new ActivationFunction(OWN, requireName(name), Objects.requireNonNull(function, "function"));
    }

    /**
     * A function of the user's own whose class has not been loaded.
     *
     * @throws IllegalArgumentException if the text cannot be the name of a class
     */
    public static ActivationFunction ofClass(String className) {
        return new ActivationFunction(OWN, requireName(className), null);
    }

    private static String requireName(String className) {
        boolean isName = !className.isEmpty()
                && className.chars().allMatch(c -> c == '.' || Character.isJavaIdentifierPart(c))
                && className.chars().noneMatch(Character::isIdentifierIgnorable);
        if (!isName) {
            throw new IllegalArgumentException("'" + className + "' cannot be the name of a class");
        }
        return className;
    }

    /** The original's code {@code ftype}, 0 to 4; -1 for a function of the user's own. */
    public int code() {
        return code;
    }

    /** The name: lower case with underscores for the built-in ones, else that of the class. */
    public String name() {
        return name;
    }

    /** Whether it is a class of the user's own. */
    public boolean isOwn() {
        return code == OWN;
    }

    /** Whether it can be computed: it is built-in, or the object of the user's class is known. */
    public boolean isBound() {
        return !isOwn() || function != null;
    }

    /**
     * Refuses a function that cannot be computed.
     *
     * @throws BadPartException if it is not {@linkplain #isBound bound}
     */
    public void requireBound() {
        if (!isBound()) {
            throw new BadPartException(described(), "its class has not been loaded");
        }
    }

    /**
     * Computes a function of the user's own.
     *
     * @throws BadPartException if it is not {@linkplain #isBound bound}, or it throws or returns no finite number
     */
    public double ofOwn(double sum) {
        requireBound();
        NeuronFunction own = Objects.requireNonNull(function, "a built-in function is computed elsewhere");
        double activation;
        try {
            activation = own.of(sum);
        } catch (Throwable e) {
            new Thrown(e).passOnIfOfTheMachine();
            throw new BadPartException(described(), e);
        }
        if (!Double.isFinite(activation)) {
            throw new BadPartException(
                    described(), "gave " + activation + " for the sum " + sum + "; it must give a finite number");
        }
        return activation;
    }

    private String described() {
        return "activation function " + name;
    }

    /** Equal in code and name, bound or not. */
    @Override
    public boolean equals(Object other) {
        return this == other || other instanceof ActivationFunction that && code == that.code && name.equals(that.name);
    }

    @Override
    public int hashCode() {
        return name.hashCode();
    }

    @Override
    public String toString() {
        return name;
    }
}
