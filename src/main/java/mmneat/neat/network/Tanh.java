package mmneat.neat.network;

/**
 * The hyperbolic tangent of {@link StrictMath#tanh}, bit for bit, several times as fast.
 *
 * <p>Source: the freely distributable mathematics library fdlibm 5.3 (s_tanh.c, s_expm1.c), which {@code StrictMath} is
 * defined by:
 *
 * <pre>
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 *
 * Developed at SunSoft, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this
 * software is freely granted, provided that this notice
 * is preserved.
 * </pre>
 */
public final class Tanh {

    /*
     * The reference algorithm, for a = |x| and y = 2a:
     *
     *   t = expm1(y)  and  1 - 2/(t + 2)   if a >= 1
     *   t = expm1(-y) and  -t/(t + 2)      if a < 1
     *
     * where expm1(s y) (s = 1 or -1) subtracts k ln 2 (k nearest to y/ln 2) from y, leaving r with a rest c, and adds the
     * exponent back: by one formula for k = 0, another for s k = -1, a third for s k <= -2 or > 56, and two more for small
     * and large k. A neuron's sum may fall anywhere, so that these branches are mispredicted time and again, and a call
     * into the native library keeps the processor from working on the next neuron meanwhile.
     *
     * Here all cases are one straight line,
     *
     *   q = M + (s r - (e + T)),   t = q F + G,   tanh a = D + (q N + P)/(t + 2),
     *
     * with the constants of a case in a row of a table. The cases come out the same to the last bit because adding 0,
     * multiplying by 1 or a power of two (far from overflow and underflow) and changing signs are exact:
     *
     *   case             M          T      F      G        as in the reference
     *   k = 0            0          0      1      0        x - (xe - hxs)
     *   s k = -1         0          0      1/2    -1/2     0.5 (x - e) - 0.5
     *   s k <= -2        1          0      2^sk   -1       (1 - (e - x)) 2^k - 1
     *   3 <= s k < 20    1 - 2^-k   0      2^k    0        ((1 - 2^-k) - (e - x)) 2^k
     *   20 <= s k <= 56  1          2^-k   2^k    0        ((x - (e + 2^-k)) + 1) 2^k
     *
     *   a < 1: D = 0, N = -F, P = -G (so the numerator is -t);   a >= 1: D = 1, N = 0, P = -2.
     *
     * For negative x the signs of D, N and P are turned.
     *
     * Where a >= 19.0625 the quotient is below 2^-54 and the result 1; the reference's own bounds (22, and 56 ln 2 in
     * expm1) are never reached, and tiny arguments come out right without a case of their own.
     */

    private static final double LN2_HIGH = 6.93147180369123816490e-01;
    private static final double LN2_LOW = 1.90821492927058770002e-10;
    private static final double INVERSE_LN2 = 1.44269504088896338700e+00;
    private static final double Q1 = -3.33333333333331316428e-02;
    private static final double Q2 = 1.58730158725481460165e-03;
    private static final double Q3 = -7.93650757867487942473e-05;
    private static final double Q4 = 4.00821782732936239552e-06;
    private static final double Q5 = -2.01099218183624371326e-07;

    /** From here on the result is 1. */
    private static final double SATURATION = 19.0625;

    /**
     * The reference compares y with ln(2)/2 by the upper half of its bits alone, and so takes k = 0 in a small interval
     * where rounding would give 1. The upper half of a = y/2 there.
     */
    private static final int UPPER_HALF_OF_BOUND = 0x3fc62e42;

    private static final int UPPER_HALF_OF_ONE = 0x3ff00000;

    private static final int ROW_BITS = 4;
    /** Rows for x >= 0: k for a < 1 (k in 0..3), then k + 1 for a >= 1 (k in 3..55). As many again for x < 0. */
    private static final int ROWS = 64;

    /** Per row: k LN2_HIGH, k LN2_LOW, s, M, T, F, G, N, P, D; N, P and D with the signs that make the result sign(x) tanh a. */
    private static final double[] CASES = cases();

    private Tanh() {}

    private static double[] cases() {
        double[] table = new double[2 * ROWS << ROW_BITS];
        for (int row = 0; row < 2 * ROWS; row++) {
            double sign = row < ROWS ? 1 : -1;
            int index = row % ROWS;
            boolean small = index < 4;
            int k = small ? index : index - 1;
            double powerOfTwo = Math.scalb(1.0, small ? -k : k);
            double inversePower = 1 / powerOfTwo;
            // -0 is what leaves every number as it is, -0 included: zeros keep their sign.
            double g = small && k > 0 ? (k == 1 ? -0.5 : -1) : -0.0;
            double[] constants = {
                k * LN2_HIGH,
                k * LN2_LOW,
                small ? -1 : 1,
                small ? (k <= 1 ? -0.0 : 1) : (k < 20 ? 1 - inversePower : 1),
                small || k < 20 ? 0 : inversePower,
                powerOfTwo,
                g,
                small ? -sign * powerOfTwo : 0,
                small ? (g == 0 ? -0.0 : -sign * g) : -sign * 2,
                small ? sign * 0.0 : sign
            };
            System.arraycopy(constants, 0, table, row << ROW_BITS, constants.length);
        }
        return table;
    }

    /** The hyperbolic tangent of {@code x}, in [-1, 1]; equal to {@code StrictMath.tanh(x)} for every argument. */
    public static double of(double x) {
        double a = Math.abs(x);
        if (!(a < SATURATION)) {
            return Double.isNaN(x) ? x + x : Math.copySign(1.0, x);
        }
        double y = a + a;
        int k = (int) (INVERSE_LN2 * y + 0.5);
        int upper = (int) (Double.doubleToRawLongBits(x) >>> 32);
        int magnitude = upper & Integer.MAX_VALUE;
        if (magnitude == UPPER_HALF_OF_BOUND) {
            k = 0;
        }
        // 1 if a >= 1, without a branch.
        int large = 1 - (magnitude - UPPER_HALF_OF_ONE >>> 31);
        // A sum, not an "or": the compiler then knows that the row is in the table and checks no bounds.
        int row = ((k + large & ROWS - 1) + (upper >>> 31) * ROWS) << ROW_BITS;

        double s = CASES[row + 2];
        double high = y - CASES[row];
        double low = CASES[row + 1];
        double reduced = high - low;
        double c = s * ((high - reduced) - low);
        double r = s * reduced;
        double half = 0.5 * r;
        double square = reduced * (0.5 * reduced);
        double r1 = 1 + square * (Q1 + square * (Q2 + square * (Q3 + square * (Q4 + square * Q5))));
        double u = 3 - r1 * half;
        double e = square * ((r1 - u) / (6 - r * u));
        e = (r * (e - c) - c) - square;

        double q = CASES[row + 3] + (r - (e + CASES[row + 4]));
        double t = q * CASES[row + 5] + CASES[row + 6];
        return CASES[row + 9] + (q * CASES[row + 7] + CASES[row + 8]) / (t + 2);
    }
}
