package mmneat.random;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import org.junit.jupiter.api.Test;

class ArgmaxTest {

    private final ResumableRandom random = new ResumableRandom(1);

    @Test
    void ties_areDrawnAmongTheirIndicesInOrder_zerosOfBothSignsAreEqual() {
        double[] values = {-1, 0.0, -0.5, -0.0, Double.NaN, 0.0};
        int[] highest = {1, 3, 5};
        for (int i = 0; i < 100; i++) {
            int expected = highest[random.copy().nextInt(3)];
            assertThat(Argmax.of(values, random)).isEqualTo(expected);
        }
    }

    @Test
    void singleHighest_takesOneDrawToo() {
        ResumableRandom expected = random.copy();
        expected.nextInt(1);
        assertThat(Argmax.of(new double[] {Double.NEGATIVE_INFINITY, 3, 2}, random))
                .isEqualTo(1);
        assertThat(random.nextLong()).isEqualTo(expected.nextLong());
    }

    @Test
    void allNan_isRefused() {
        assertThatIllegalStateException().isThrownBy(() -> Argmax.of(new double[] {Double.NaN, Double.NaN}, random));
    }
}
