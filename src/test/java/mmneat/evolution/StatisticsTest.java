package mmneat.evolution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import mmneat.random.ResumableRandom;
import org.apache.commons.math3.stat.descriptive.DescriptiveStatistics;
import org.junit.jupiter.api.Test;

class StatisticsTest {

    @Test
    void sampleStatistics_agreeWithTheTextbook() {
        ResumableRandom random = new ResumableRandom(5);
        for (int round = 0; round < 200; round++) {
            double[] sample = IntStream.range(0, 2 + random.nextInt(50))
                    .mapToDouble(i -> 1000 * random.nextGaussian())
                    .toArray();
            DescriptiveStatistics expected = new DescriptiveStatistics(sample);
            SampleStatistics statistics = SampleStatistics.of(sample);
            assertThat(statistics.min()).isEqualTo(expected.getMin());
            assertThat(statistics.max()).isEqualTo(expected.getMax());
            assertThat(statistics.mean()).isCloseTo(expected.getMean(), within(1e-9));
            assertThat(statistics.deviation()).isCloseTo(expected.getStandardDeviation(), within(1e-9));
        }
    }

    @Test
    void deviationOfOneValue_isNotANumber() {
        assertThat(SampleStatistics.of(3).deviation()).isNaN();
        assertThat(SampleStatistics.of(3).mean()).isEqualTo(3);
    }

    @Test
    void average_isTheRunningMean_toTheLastBit() {
        assertThat(ScoreStatistic.AVERAGE.of(1, 0, 0)).isEqualTo(1 + (0 - 1.0) / 2 + (0 - 0.5) / 3);
        double[] thirds = {0.1, 0.2, 0.3, 0.7, 0.9, 1.1, 1.3};
        double mean = 0;
        for (int i = 0; i < thirds.length; i++) {
            mean += (thirds[i] - mean) / (i + 1);
        }
        assertThat(ScoreStatistic.AVERAGE.of(thirds)).isEqualTo(mean);
    }

    @Test
    void mode_isTheMostFrequent_tiesGoToTheLarger() {
        assertThat(ScoreStatistic.MODE.of(2, 1, 2, 3)).isEqualTo(2);
        assertThat(ScoreStatistic.MODE.of(1, 2, 2, 1, 3)).isEqualTo(2);
        assertThat(ScoreStatistic.MODE.of(4)).isEqualTo(4);
    }

    @Test
    void mode_countsNeighboursAsTheFirstOfTheirGroup() {
        assertThat(ScoreStatistic.MODE.of(1.0009, 1, 1.0005, 5, 5)).isEqualTo(1);
        assertThat(ScoreStatistic.MODE.of(1.002, 1, 1.0025)).isEqualTo(1.002);
    }

    @Test
    void mode_valueExactlyAThousandthAbove_startsANewGroup() {
        assertThat(ScoreStatistic.MODE.of(0, 0.001)).isEqualTo(0.001);
        assertThat(ScoreStatistic.MODE.of(0, Math.nextDown(0.001))).isZero();
    }

    @Test
    void medianAndUpperQuartile_interpolateBetweenNeighbours() {
        assertThat(ScoreStatistic.MEDIAN.of(3, 1, 2)).isEqualTo(2);
        assertThat(ScoreStatistic.MEDIAN.of(4, 1, 3, 2)).isEqualTo(2.5);
        assertThat(ScoreStatistic.UPPER_QUARTILE.of(7)).isEqualTo(7);
        assertThat(ScoreStatistic.UPPER_QUARTILE.of(1, 9))
                .as("position 2.25 of 2")
                .isEqualTo(9);
        assertThat(ScoreStatistic.UPPER_QUARTILE.of(5, 1, 2, 4, 3, 6))
                .as("position 5.25")
                .isEqualTo(5.25);
        assertThat(ScoreStatistic.MIN.of(-3, -1, -2)).isEqualTo(-3);
        assertThat(ScoreStatistic.named("UpperQuartile")).isEqualTo(ScoreStatistic.UPPER_QUARTILE);
        assertThatThrownBy(() -> ScoreStatistic.named("Mean")).hasMessage("no statistic is called Mean");
    }

    @Test
    void max_isTheMaximum() {
        assertThat(ScoreStatistic.MAX.of(-3, -1, -2)).isEqualTo(-1);
    }

    @Test
    void noValues_haveNoMean() {
        assertThatThrownBy(SampleStatistics::meanOf).hasMessage("no values to average");
    }

    @Test
    void noValues_haveNoStatistics() {
        assertThatThrownBy(SampleStatistics::varianceOf).hasMessage("no values to take the variance of");
        assertThatThrownBy(SampleStatistics::of)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("no values to describe");
        for (ScoreStatistic statistic : ScoreStatistic.values()) {
            assertThatThrownBy(statistic::of)
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageStartingWith("no values to ");
        }
    }
}
