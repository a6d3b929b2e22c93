package mmneat.analysis.figures;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AxisTest {

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0 | 10 | 6 | 0 2 4 6 8 10",
                "0 | 9000 | 10 | 0 1,000 2,000 3,000 4,000 5,000 6,000 7,000 8,000 9,000",
                "-1 | 1 | 4 | -1.0 -0.5 0 0.5 1.0",
                "0 | 0.02 | 4 | 0 0.005 0.010 0.015 0.020",
                "3 | 3 | 4 | 3.0 3.5 4.0",
                "0 | 1e17 | 5 | 0 2E16 4E16 6E16 8E16 1E17",
                "0 | 2e-8 | 4 | 0 5E-9 1E-8 1.5E-8 2E-8",
            })
    void ticks_areRoundNumbersThatAreToldApart(double low, double high, int most, String labels) {
        Axis axis = Axis.of(low, high);
        List<String> drawn =
                axis.ticks(most).stream().map(tick -> axis.label(tick, most)).toList();
        assertThat(String.join(" ", drawn)).isEqualTo(labels);
    }

    @ParameterizedTest
    @CsvSource({
        "1e17, 1e17",
        "1e17, 100000000000000016",
        "-1.7e308, 1.7e308",
        "0, Infinity",
        "NaN, NaN",
        "0, 4.9e-324",
        "-1e300, -1e300",
        "5, 3"
    })
    void degenerateRanges_haveFewTicksWithinTheAxis(double low, double high) {
        Axis axis = Axis.of(low, high);
        assertThat(axis.high()).isGreaterThan(axis.low());
        assertThat(axis.ticks(8)).hasSizeBetween(1, 9).allSatisfy(tick -> assertThat(axis.share(tick))
                .isBetween(-0.001, 1.001));
        assertThat(axis.ticks(8).stream().map(tick -> axis.label(tick, 8))).doesNotHaveDuplicates();
    }
}
