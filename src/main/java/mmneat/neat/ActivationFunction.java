package mmneat.neat;

/**
 * The function that turns a neuron's sum into its activation; {@code mmneat.neat.network} computes it.
 *
 * <p>Source: docs/specification/networks.md, section 5.3.
 */
public enum ActivationFunction {
    /** 1 / (1 + e(-x)), the exponent clamped to [-7, 7]. */
    LOGISTIC,
    /** Hyperbolic tangent: the function of all published experiments. */
    TANH,
    /** The sum itself. */
    IDENTITY,
    /** The approximate logistic function, stretched to (-1, 1). */
    APPROXIMATE_TANH,
    /** The logistic function with an exponential made of the bits of a double. */
    APPROXIMATE_LOGISTIC;

    private static final ActivationFunction[] BY_CODE = values();

    /** The original's code {@code ftype}, 0 to 4. */
    public int code() {
        return ordinal();
    }

    /**
     * The function with the original's code.
     *
     * @throws IllegalArgumentException if no function has this code
     */
    public static ActivationFunction ofCode(int code) {
        if (code < 0 || code >= BY_CODE.length) {
            throw new IllegalArgumentException("activation function must be 0 to 4, is " + code);
        }
        return BY_CODE[code];
    }
}
