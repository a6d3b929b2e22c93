package mmneat.neat.network;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class RoughTanhTest {

    private final SplittableRandom random = new SplittableRandom(3);

    @Test
    void everyArgument_isWithinTheLargestError() {
        for (int i = 0; i < 2_000_000; i++) {
            assertClose(random.nextDouble(-10, 10));
        }
        for (double bound = -9.5; bound < 10; bound += 1.0 / 32) {
            assertClose(bound);
            assertClose(Math.nextUp(bound));
            assertClose(Math.nextDown(bound));
        }
        assertClose(0.0);
        assertClose(Double.MAX_VALUE);
        assertClose(Double.NEGATIVE_INFINITY);
    }

    @Test
    void nan_staysNan() {
        assertThat(RoughTanh.of(Double.NaN)).isNaN();
    }

    private static void assertClose(double x) {
        double error = Math.abs(RoughTanh.of(x) - StrictMath.tanh(x));
        if (!(error < RoughTanh.LARGEST_ERROR)) {
            assertThat(error).as("at %s", x).isLessThan(RoughTanh.LARGEST_ERROR);
        }
    }
}
