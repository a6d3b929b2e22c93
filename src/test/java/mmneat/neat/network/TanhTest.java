package mmneat.neat.network;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import java.util.function.DoubleSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The fast hyperbolic tangent against {@link StrictMath}, bit for bit. */
class TanhTest {

    private static final int ARGUMENTS = 4_000_000;
    private static final int NEIGHBOURS = 50_000;

    private final SplittableRandom random = new SplittableRandom(20260101);

    @ParameterizedTest
    @ValueSource(
            doubles = {
                0.0,
                Double.MIN_VALUE,
                Double.MIN_NORMAL,
                0x1p-55,
                0x1p-54,
                0.25,
                0.5,
                1,
                2,
                6.75,
                7,
                19.0625,
                22,
                44,
                709.782712893384,
                1e300,
                Double.MAX_VALUE,
                Double.POSITIVE_INFINITY,
                Double.NaN
            })
    void specialValues_ofBothSigns_areEqual(double value) {
        assertEqual(value);
        assertEqual(-value);
    }

    @Test
    void zero_keepsItsSign() {
        assertThat(Double.doubleToRawLongBits(Tanh.of(-0.0))).isEqualTo(Double.doubleToRawLongBits(-0.0));
    }

    @Test
    void sumsAsInNetworks_areEqual() {
        compare(() -> random.nextDouble(-4, 4));
    }

    @Test
    void wholeUnsaturatedRange_isEqual() {
        compare(() -> random.nextDouble(-23, 23));
    }

    @Test
    void smallArguments_ofEveryMagnitude_areEqual() {
        compare(() -> random.nextDouble(-1, 1) * Math.scalb(1.0, -random.nextInt(1080)));
    }

    @Test
    void anyBits_areEqual() {
        compare(() -> Double.longBitsToDouble(random.nextLong()));
    }

    /** Arguments at which the reference changes its formula, and the bounds of our own cases. */
    @ParameterizedTest
    @ValueSource(
            doubles = {
                0x1p-55,
                0x1p-54,
                0x1.62e42p-3, // expm1 leaves its argument as it is up to ln(2)/2, by the upper half of the bits
                0x1.62e42fefa39efp-3,
                0x1.62e43p-3,
                0x1.0a2b2p-1, // 1.5 ln 2: k is computed from here on
                0x1.0a2b23f3bab73p-1,
                6.75,
                1, // tanh changes the sign of expm1's argument
                19.061547465398498, // 55 ln 2 / 2
                19.0625,
                19.408121055678468, // 56 ln 2 / 2
                22
            })
    void neighboursOfThresholds_areEqual(double threshold) {
        assertNeighboursEqual(threshold);
    }

    /** Half-way between multiples of ln 2 the number of subtracted multiples changes. */
    @Test
    void neighboursOfReductionBounds_areEqual() {
        for (int k = 0; k <= 60; k++) {
            assertNeighboursEqual((k + 0.5) * Math.log(2) / 2);
        }
    }

    private void assertNeighboursEqual(double threshold) {
        long bits = Double.doubleToRawLongBits(threshold);
        for (int offset = -NEIGHBOURS; offset <= NEIGHBOURS; offset++) {
            assertEqual(Double.longBitsToDouble(bits + offset));
        }
        for (int i = 0; i < NEIGHBOURS; i++) {
            assertEqual(-threshold * (1 + random.nextDouble(-1e-5, 1e-5)));
        }
    }

    private static void compare(DoubleSupplier arguments) {
        for (int i = 0; i < ARGUMENTS; i++) {
            assertEqual(arguments.getAsDouble());
        }
    }

    private static void assertEqual(double x) {
        double expected = StrictMath.tanh(x);
        double actual = Tanh.of(x);
        if (Double.doubleToLongBits(actual) != Double.doubleToLongBits(expected)) {
            assertThat(Double.toHexString(actual))
                    .as("tanh(%s)", Double.toHexString(x))
                    .isEqualTo(Double.toHexString(expected));
        }
    }
}
