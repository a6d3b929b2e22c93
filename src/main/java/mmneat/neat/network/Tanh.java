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
     * where expm1(s y) (s = 1 or -1) subtracts k ln 2 (k nearest to y/ln 2) from y, leaving r with a rest c, and adds
     * the exponent back: by one formula for k = 0, another for s k = -1, a third for s k <= -2, and more for large k. A
     * neuron's sum may fall anywhere, so that these branches are mispredicted time and again, and a call into the
     * native library keeps the processor from working on the next neuron meanwhile.
     *
     * Here all cases up to k = 19 are one straight line,
     *
     *   q = M + (s r - e),   t = q F + G,   tanh a = D + (q N + P)/(t + 2),
     *
     * with the constants of a case in a row of a table. The cases come out the same to the last bit because adding 0,
     * multiplying by 1 or a power of two (far from overflow and underflow) and changing signs are exact:
     *
     *   case             M          F      G        as in the reference
     *   k = 0            0          1      0        x - (xe - hxs)
     *   s k = -1         0          1/2    -1/2     0.5 (x - e) - 0.5
     *   s k <= -2        1          2^sk   -1       (1 - (e - x)) 2^k - 1
     *   3 <= s k < 20    1 - 2^-k   2^k    0        ((1 - 2^-k) - (e - x)) 2^k
     *
     *   a < 1: D = 0, N = -F, P = -G (so the numerator is -t);   a >= 1: D = 1, N = 0, P = -2.
     *
     * For negative x the signs of D, N and P are turned.
     *
     * The nearest k comes from adding and subtracting a number so large that no fraction fits beside it, which is
     * sooner done than a conversion; the reference adds 0.5 and cuts off, and decides between k = 0 and 1 by the upper
     * half of the bits. They differ only very near the middle between two k: such arguments, one in half a million, go
     * to the library, as do the few beyond the table.
     */

    private static final double LN2_HIGH = 6.93147180369123816490e-01;
    private static final double LN2_LOW = 1.90821492927058770002e-10;
    private static final double INVERSE_LN2 = 1.44269504088896338700e+00;
    private static final double Q1 = -3.33333333333331316428e-02;
    private static final double Q2 = 1.58730158725481460165e-03;
    private static final double Q3 = -7.93650757867487942473e-05;
    private static final double Q4 = 4.00821782732936239552e-06;
    private static final double Q5 = -2.01099218183624371326e-07;

    /** Three halves of 2^52: a sum with it is a whole number, in the lower bits. */
    private static final double WHOLE = 0x1.8p52;

    /** From here on k is 20 or more. */
    private static final double TABLE_END = 6.75;

    /** ln(2)/2 minus a safety margin: below it, the rounded k is the nearest integer. */
    private static final double CLEARLY_NEAREST = 0.346573;

    /** From here on the result is 1: 2/(t + 2) is below 2^-54. */
    private static final double SATURATION = 19.0625;

    /** Raises the exponent in the bits of a number by one. */
    private static final long ONE_EXPONENT = 1L << 52;

    private static final int ROW_BITS = 3;
    private static final int ROWS = 128;
    private static final int LARGEST_K = 19;

    /**
     * Per row: M, F, G, N, P, D, s; N, P and D with the signs that make the result sign(x) tanh a. Row 4k + 2[x &lt; 0]
     * + [a &ge; 1].
     */
    private static final double[] CASES = cases();

    private Tanh() {}

    private static double[] cases() {
        double[] table = new double[ROWS << ROW_BITS];
        for (int row = 0; row < 4 * (LARGEST_K + 1); row++) {
            double sign = (row & 2) == 0 ? 1 : -1;
            boolean small = (row & 1) == 0;
            int k = row >> 2;
            double powerOfTwo = Math.scalb(1.0, small ? -k : k);
            // -0 is what leaves every number as it is, -0 included: zeros keep their sign.
            double g = small && k > 0 ? (k == 1 ? -0.5 : -1) : -0.0;
            double[] constants = {
                small ? (k <= 1 ? -0.0 : 1) : 1 - 1 / powerOfTwo,
                powerOfTwo,
                g,
                small ? -sign * powerOfTwo : 0,
                small ? (g == 0 ? -0.0 : -sign * g) : -sign * 2,
                small ? sign * 0.0 : sign,
                small ? -1 : 1
            };
            System.arraycopy(constants, 0, table, row << ROW_BITS, constants.length);
        }
        return table;
    }

    /** The hyperbolic tangent of {@code x}, in [-1, 1]; equal to {@code StrictMath.tanh(x)} for every argument. */
    public static double of(double x) {
        return isInTable(x) ? inTable(x) : outsideTable(x);
    }

    /**
     * Whether {@link #inTable} can be asked: so for all arguments but those beyond 6.75, and one in half a million
     * before.
     */
    static boolean isInTable(double x) {
        double a = Math.abs(x);
        double k = wholeOf(a) - WHOLE;
        return a < TABLE_END && Math.abs(high(a, k) - k * LN2_LOW) <= CLEARLY_NEAREST;
    }

    /** The hyperbolic tangent of an argument in the table; any number for others. Calls nothing. */
    static double inTable(double x) {
        double a = Math.abs(x);
        double whole = wholeOf(a);
        double k = whole - WHOLE;
        double high = high(a, k);
        double low = k * LN2_LOW;
        double reduced = high - low;
        int row = row(x, whole);

        double s = CASES[row + 6];
        double c = s * ((high - reduced) - low);
        double r = s * reduced;
        double half = 0.5 * r;
        double square = reduced * (0.5 * reduced);
        double r1 = 1 + square * (Q1 + square * (Q2 + square * (Q3 + square * (Q4 + square * Q5))));
        double u = 3 - r1 * half;
        double e = square * ((r1 - u) / (6 - r * u));
        e = (r * (e - c) - c) - square;

        double q = CASES[row] + (r - e);
        double t = q * CASES[row + 1] + CASES[row + 2];
        return CASES[row + 5] + (q * CASES[row + 3] + CASES[row + 4]) / (t + 2);
    }

    /** A number with k in its lower bits. */
    private static double wholeOf(double a) {
        return (2 * INVERSE_LN2) * a + WHOLE;
    }

    /** 2a less the upper part of k ln 2. */
    private static double high(double a, double k) {
        return (a + a) - k * LN2_HIGH;
    }

    /** Start of the row of an argument in the table; {@code whole} has k in its lower bits. */
    private static int row(double x, double whole) {
        // The sum carries into bit 62 if the exponent is that of 1 or more.
        int signAndSize = (int) (Double.doubleToRawLongBits(x) + ONE_EXPONENT >>> 62);
        int k = (int) Double.doubleToRawLongBits(whole);
        // A sum, not an "or", and a mask: the compiler then knows that the row is in the table and checks no bounds.
        return (4 * k + signAndSize & ROWS - 1) << ROW_BITS;
    }

    private static double outsideTable(double x) {
        return Math.abs(x) >= SATURATION ? Math.copySign(1.0, x) : StrictMath.tanh(x);
    }
}
