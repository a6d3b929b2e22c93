package mmneat.neat.network;

/**
 * The hyperbolic tangent to within {@link #LARGEST_ERROR}, several times as fast as to the last bit: for telling apart
 * values that are clearly different.
 */
final class RoughTanh {

    /*
     * A cubic per interval of a sixteenth, in powers of the distance from the interval's middle: the one that has the
     * values and slopes of the tangent at both ends. The interval's number comes from adding a number so large that no
     * fraction fits beside it.
     */

    /** Most that a result differs from the hyperbolic tangent, rounding included. */
    static final double LARGEST_ERROR = 2e-7;

    private static final int INTERVALS_PER_UNIT = 16;
    private static final double BOUND = 9;
    private static final double WHOLE = 0x1.8p52;
    private static final int ROW_BITS = 2;
    private static final int ROWS = 512;

    /** Coefficients of the cubic around n sixteenths, lowest power first, in row n modulo {@link #ROWS}. */
    private static final double[] CUBICS = cubics();

    private RoughTanh() {}

    private static double[] cubics() {
        double[] table = new double[ROWS << ROW_BITS];
        int last = (int) BOUND * INTERVALS_PER_UNIT;
        for (int n = -last; n <= last; n++) {
            double left = StrictMath.tanh((n - 0.5) / INTERVALS_PER_UNIT);
            double right = StrictMath.tanh((n + 0.5) / INTERVALS_PER_UNIT);
            double leftSlope = (1 - left * left) / INTERVALS_PER_UNIT;
            double rightSlope = (1 - right * right) / INTERVALS_PER_UNIT;
            int row = (n & ROWS - 1) << ROW_BITS;
            table[row] = (left + right) / 2 + (leftSlope - rightSlope) / 8;
            table[row + 1] = 1.5 * (right - left) - (leftSlope + rightSlope) / 4;
            table[row + 2] = (rightSlope - leftSlope) / 2;
            table[row + 3] = leftSlope + rightSlope - 2 * (right - left);
        }
        return table;
    }

    /** About the hyperbolic tangent; not a number for what is none. */
    static double of(double x) {
        if (!(Math.abs(x) < BOUND)) {
            return x > 0 ? 1 : x < 0 ? -1 : x;
        }
        double scaled = x * INTERVALS_PER_UNIT;
        double whole = scaled + WHOLE;
        double d = scaled - (whole - WHOLE);
        int row = ((int) Double.doubleToRawLongBits(whole) & ROWS - 1) << ROW_BITS;
        return (CUBICS[row] + d * CUBICS[row + 1]) + d * d * (CUBICS[row + 2] + d * CUBICS[row + 3]);
    }
}
