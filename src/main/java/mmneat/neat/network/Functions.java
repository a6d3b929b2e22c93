package mmneat.neat.network;

import mmneat.neat.ActivationFunction;

/**
 * The activation functions.
 *
 * <p>Source: docs/specification/networks.md, section 5.3; the exponential made of the bits of a double: Schraudolph
 * 1999.
 */
final class Functions {

    /** Beyond this the logistic function takes its exponential to be constant. */
    private static final double LOGISTIC_BOUND = 7;

    private static final double HIGHEST_EXPONENTIAL = StrictMath.exp(LOGISTIC_BOUND);
    private static final double LOWEST_EXPONENTIAL = StrictMath.exp(-LOGISTIC_BOUND);

    private Functions() {}

    /**
     * Activation of a neuron with this function and sum.
     *
     * @throws mmneat.neat.BadPartException as {@link ActivationFunction#ofOwn}
     */
    static double of(ActivationFunction function, double sum) {
        // The cases are the original's codes of the constants of ActivationFunction.
        return switch (function.code()) {
            case 0 -> 1 / (1 + boundedExponential(-sum));
            case 1 -> Tanh.of(sum);
            case 2 -> sum;
            case 3 -> 2 * approximateLogistic(sum) - 1;
            case 4 -> approximateLogistic(sum);
            default -> function.ofOwn(sum);
        };
    }

    private static double boundedExponential(double x) {
        if (Math.abs(x) < LOGISTIC_BOUND) {
            return StrictMath.exp(x);
        }
        return x > 0 ? HIGHEST_EXPONENTIAL : LOWEST_EXPONENTIAL;
    }

    private static double approximateLogistic(double x) {
        return 1 / (1 + approximateExponential(-x));
    }

    /** A straight line written into the exponent and upper mantissa bits: within a few per cent of exp. */
    private static double approximateExponential(double x) {
        return Double.longBitsToDouble((long) (1512775 * x + 1072632447) << 32);
    }
}
