package mmneat.experiment.store;

import java.math.BigInteger;

/**
 * Formats doubles as in the original's files: like {@code Double.toString} before Java 19.
 *
 * <p>Since Java 19 {@code Double.toString} returns the shortest digits that read back as the same double; before, it
 * sometimes returned one digit more. Files must not depend on the version of Java, so this class implements the older
 * rule.
 *
 * <p>The older rule is a variant of the free-format algorithm of Steele and White. Source: G. L. Steele, J. L. White:
 * How to print floating-point numbers accurately, PLDI 1990; docs/specification/evolution.md, section 5.
 */
public final class DoubleText {

    private static final int FRACTION_BITS = 52;
    private static final int LARGEST_EXACT_INTEGER_EXPONENT = 62;
    private static final double LARGEST_PLAIN = 1e7;

    /** The powers of 5 that fit into a long. */
    private static final long[] POWERS_OF_5 = new long[28];

    static {
        POWERS_OF_5[0] = 1;
        for (int power = 1; power < POWERS_OF_5.length; power++) {
            POWERS_OF_5[power] = POWERS_OF_5[power - 1] * 5;
        }
    }

    /** Digits without leading zeros. */
    private final StringBuilder digits = new StringBuilder(20);

    /** The value is 0.DIGITS times ten to this power. */
    private int decimalExponent;

    private DoubleText() {}

    /** The text of any double. */
    public static String of(double value) {
        if (value == (long) value && Math.abs(value) < LARGEST_PLAIN) {
            return (value == 0 && 1 / value < 0 ? "-0" : Long.toString((long) value)) + ".0";
        }
        if (Double.isNaN(value) || Double.isInfinite(value)) {
            return Double.toString(value);
        }
        DoubleText text = new DoubleText();
        text.develop(Math.abs(value));
        return (value < 0 ? "-" : "") + text.notation();
    }

    private void develop(double value) {
        long bits = Double.doubleToLongBits(value);
        long fraction = bits & ((1L << FRACTION_BITS) - 1);
        int exponent = (int) (bits >>> FRACTION_BITS) - 1023;
        int significantBits = FRACTION_BITS + 1;
        if (exponent == -1023) {
            // Subnormal: shifted until the leading bit is at the position of the implicit bit of normal numbers.
            int shift = Long.numberOfLeadingZeros(fraction) - (63 - FRACTION_BITS);
            fraction <<= shift;
            exponent = -1022 - shift;
            significantBits -= shift;
        } else {
            fraction |= 1L << FRACTION_BITS;
        }
        int trailingZeros = Long.numberOfTrailingZeros(fraction);
        int usedBits = FRACTION_BITS + 1 - trailingZeros;
        boolean isInteger = usedBits <= exponent + 1;
        if (isInteger && exponent <= LARGEST_EXACT_INTEGER_EXPONENT) {
            developInteger(fraction, exponent, significantBits);
        } else {
            developFraction(fraction >>> trailingZeros, usedBits, exponent, significantBits);
        }
    }

    /** Generates the digits of an integer below 2^63, rounded to the precision of a double. */
    private void developInteger(long fraction, int exponent, int significantBits) {
        long integer = exponent >= FRACTION_BITS
                ? fraction << exponent - FRACTION_BITS
                : fraction >>> FRACTION_BITS - exponent;
        int beyond = exponent - significantBits - 1;
        int insignificant = beyond > 1 ? String.valueOf(1L << beyond).length() - 1 : 0;
        long unit = 1;
        for (int i = 0; i < insignificant; i++) {
            unit *= 10;
        }
        long kept = integer / unit + (insignificant > 0 && integer % unit >= unit / 2 ? 1 : 0);
        digits.append(kept);
        decimalExponent = digits.length() + insignificant;
        while (digits.length() > 1 && digits.charAt(digits.length() - 1) == '0') {
            digits.setLength(digits.length() - 1);
        }
    }

    /*
     * Steele and White's digit generation. The value is remainder / unit times a power of ten; halfGap is, on the same
     * scale, half the distance to the next double. Digits are produced until the rest is within halfGap of what has
     * been printed (low) or of the next higher last digit (high).
     */
    private void developFraction(long fraction, int usedBits, int exponent, int significantBits) {
        int tinyBits = Math.max(0, usedBits - exponent - 1);
        int estimate = estimatedDecimalExponent(fraction, usedBits, exponent);
        int remainder5 = Math.max(0, -estimate);
        int remainder2 = remainder5 + tinyBits + exponent;
        int unit5 = Math.max(0, estimate);
        int unit2 = unit5 + tinyBits;
        int gap2 = remainder2 - significantBits;
        remainder2 -= usedBits - 1;
        int common = Math.min(remainder2, unit2);
        remainder2 -= common;
        unit2 -= common;
        gap2 -= common;
        if (usedBits == 1) {
            // The next smaller neighbour of a power of two is only half as far away as the next larger.
            gap2--;
        }
        if (gap2 < 0) {
            remainder2 -= gap2;
            unit2 -= gap2;
            gap2 = 0;
        }
        boolean isWide =
                usedBits + remainder2 + bitsOfPowerOf5(remainder5) >= 64 || unit2 + 1 + bitsOfPowerOf5(unit5 + 1) >= 64;
        if (isWide) {
            generateDigits(
                    product(fraction, remainder5, remainder2),
                    product(1, unit5, unit2),
                    product(1, remainder5, gap2),
                    estimate);
        } else {
            generateDigits(
                    fraction * POWERS_OF_5[remainder5] << remainder2,
                    POWERS_OF_5[unit5] << unit2,
                    POWERS_OF_5[remainder5] << gap2,
                    estimate);
        }
    }

    /** Digit generation if all numbers fit into a long, as for most doubles of usual size. */
    private void generateDigits(long rest, long unit, long gap, int estimate) {
        int exponent = estimate;
        long tenUnits = unit * 10;
        int digit = (int) (rest / unit);
        long remainder = rest % unit * 10;
        long halfGap = gap * 10;
        boolean low = remainder < halfGap;
        boolean high = remainder + halfGap > tenUnits;
        if (digit == 0 && !high) {
            exponent--;
        } else {
            digits.append(digit);
        }
        if (exponent < -3 || exponent >= 8) {
            // Scientific notation has at least one digit after the point.
            low = false;
            high = false;
        }
        while (!low && !high) {
            digit = (int) (remainder / unit);
            remainder = remainder % unit * 10;
            halfGap *= 10;
            // The gap may overflow; then this digit is the last.
            low = halfGap <= 0 || remainder < halfGap;
            high = halfGap <= 0 || remainder + halfGap > tenUnits;
            digits.append(digit);
        }
        finish(exponent, low, high, Long.signum((remainder << 1) - tenUnits));
    }

    /** Digit generation if the numbers do not fit into a long. */
    private void generateDigits(BigInteger rest, BigInteger unit, BigInteger gap, int estimate) {
        int exponent = estimate;
        BigInteger tenUnits = unit.multiply(BigInteger.TEN);
        BigInteger[] split = rest.divideAndRemainder(unit);
        BigInteger remainder = split[1].multiply(BigInteger.TEN);
        BigInteger halfGap = gap.multiply(BigInteger.TEN);
        boolean low = remainder.compareTo(halfGap) < 0;
        // Unlike in the version for longs, the bound itself is included.
        boolean high = remainder.add(halfGap).compareTo(tenUnits) >= 0;
        int digit = split[0].intValue();
        if (digit == 0 && !high) {
            exponent--;
        } else {
            digits.append(digit);
        }
        if (exponent < -3 || exponent >= 8) {
            low = false;
            high = false;
        }
        while (!low && !high) {
            split = remainder.divideAndRemainder(unit);
            remainder = split[1].multiply(BigInteger.TEN);
            halfGap = halfGap.multiply(BigInteger.TEN);
            low = remainder.compareTo(halfGap) < 0;
            high = remainder.add(halfGap).compareTo(tenUnits) >= 0;
            digits.append(split[0].intValue());
        }
        finish(exponent, low, high, remainder.shiftLeft(1).compareTo(tenUnits));
    }

    /** Rounds the last digit. @param half the sign of the rest minus one half of the last digit's unit */
    private void finish(int exponent, boolean low, boolean high, int half) {
        decimalExponent = exponent + 1;
        if (high) {
            boolean lastIsOdd = (digits.charAt(digits.length() - 1) - '0') % 2 == 1;
            if (!low || half > 0 || (half == 0 && lastIsOdd)) {
                roundUp();
            }
        }
    }

    private void roundUp() {
        int last = digits.length() - 1;
        while (last > 0 && digits.charAt(last) == '9') {
            digits.setCharAt(last, '0');
            last--;
        }
        if (digits.charAt(last) == '9') {
            digits.setCharAt(last, '1');
            decimalExponent++;
        } else {
            digits.setCharAt(last, (char) (digits.charAt(last) + 1));
        }
    }

    /**
     * Estimates the decimal exponent of the first digit by a linear approximation of the logarithm; the result may be
     * one too large.
     */
    private static int estimatedDecimalExponent(long fraction, int usedBits, int exponent) {
        double significand = fraction / (double) (1L << usedBits - 1);
        return (int) Math.floor((significand - 1.5) * 0.289529654 + 0.176091259 + exponent * 0.301029995663981);
    }

    private static BigInteger product(long factor, int powerOf5, int powerOf2) {
        return BigInteger.valueOf(factor)
                .multiply(BigInteger.valueOf(5).pow(powerOf5))
                .shiftLeft(powerOf2);
    }

    /** Number of bits of a power of 5, as the older rule computes it: three bits per factor beyond its table. */
    private static int bitsOfPowerOf5(int power) {
        return power < 27 ? Long.SIZE - Long.numberOfLeadingZeros(POWERS_OF_5[power]) : power * 3;
    }

    private String notation() {
        if (decimalExponent > 0 && decimalExponent < 8) {
            int point = decimalExponent;
            if (digits.length() <= point) {
                return digits + "0".repeat(point - digits.length()) + ".0";
            }
            return digits.substring(0, point) + "." + digits.substring(point);
        }
        if (decimalExponent <= 0 && decimalExponent > -3) {
            return "0." + "0".repeat(-decimalExponent) + digits;
        }
        String behindPoint = digits.length() > 1 ? digits.substring(1) : "0";
        return digits.charAt(0) + "." + behindPoint + "E" + (decimalExponent - 1);
    }
}
