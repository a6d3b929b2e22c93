package mmneat.random;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ResumableRandomTest {

    private static final int DRAWS = 200_000;

    @ParameterizedTest
    @ValueSource(longs = {0, 1, -1, 42, 0x5DEECE66DL, Long.MAX_VALUE, Long.MIN_VALUE})
    void everyKindOfDraw_equalsJavaUtilRandom_inAnyMixture(long seed) {
        Random expected = new Random(seed);
        ResumableRandom actual = new ResumableRandom(seed);
        Random kinds = new Random(seed + 1);
        for (int i = 0; i < DRAWS; i++) {
            int bound = 1 + kinds.nextInt(kinds.nextBoolean() ? 40 : Integer.MAX_VALUE - 1);
            switch (kinds.nextInt(9)) {
                case 0 -> assertThat(actual.nextInt()).isEqualTo(expected.nextInt());
                case 1 -> assertThat(actual.nextInt(bound)).isEqualTo(expected.nextInt(bound));
                case 2 -> assertThat(actual.nextLong()).isEqualTo(expected.nextLong());
                case 3 -> assertThat(actual.nextBoolean()).isEqualTo(expected.nextBoolean());
                case 4 -> assertThat(actual.nextFloat()).isEqualTo(expected.nextFloat());
                case 5 -> assertThat(actual.nextDouble()).isEqualTo(expected.nextDouble());
                case 6 -> assertThat(actual.nextInt(64)).isEqualTo(expected.nextInt(64));
                case 7 -> {
                    byte[] expectedBytes = new byte[i % 10];
                    byte[] actualBytes = new byte[i % 10];
                    expected.nextBytes(expectedBytes);
                    actual.nextBytes(actualBytes);
                    assertThat(actualBytes).isEqualTo(expectedBytes);
                }
                default -> assertThat(actual.nextGaussian()).isEqualTo(expected.nextGaussian());
            }
        }
    }

    /** Controllers of the competition pass {@code game.rnd} to methods that take a {@code java.util.Random}. */
    @Test
    void generator_servesWhereverAJavaUtilRandomIsWanted() {
        Random actual = new ResumableRandom(5);
        Random expected = new Random(5);
        List<Integer> shuffled = new ArrayList<>(IntStream.range(0, 100).boxed().toList());
        List<Integer> asExpected = new ArrayList<>(shuffled);
        Collections.shuffle(shuffled, actual);
        Collections.shuffle(asExpected, expected);
        assertThat(shuffled).isEqualTo(asExpected);
        assertThat(actual.ints(50, -3, 1000).toArray())
                .isEqualTo(expected.ints(50, -3, 1000).toArray());
        assertThat(actual.doubles(50).toArray()).isEqualTo(expected.doubles(50).toArray());
        assertThat(actual.nextInt(7, 19)).isEqualTo(expected.nextInt(7, 19));
        assertThat(actual.nextGaussian(3, 2)).isEqualTo(expected.nextGaussian(3, 2));
        actual.setSeed(9);
        expected.setSeed(9);
        assertThat(actual.nextLong()).isEqualTo(expected.nextLong());
    }

    @Test
    void resumedGenerator_continuesTheSequence_includingACachedGaussian() {
        ResumableRandom original = new ResumableRandom(7);
        original.nextGaussian();
        ResumableRandom resumed = ResumableRandom.resume(original.state());
        ResumableRandom copied = original.copy();
        for (int i = 0; i < 1000; i++) {
            double expected = original.nextGaussian();
            assertThat(resumed.nextGaussian()).isEqualTo(expected);
            assertThat(copied.nextGaussian()).isEqualTo(expected);
        }
    }

    @Test
    void setSeed_dropsTheCachedGaussian() {
        ResumableRandom random = new ResumableRandom(3);
        double first = random.nextGaussian();
        random.setSeed(3);
        assertThat(random.nextGaussian()).isEqualTo(first);
    }

    @Test
    void boundThatIsNotPositive_isRefused() {
        assertThatIllegalArgumentException().isThrownBy(() -> new ResumableRandom(1).nextInt(0));
    }
}
