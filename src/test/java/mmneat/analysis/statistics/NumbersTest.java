package mmneat.analysis.statistics;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NumbersTest {

    @ParameterizedTest
    @CsvSource({
        "12345.6, '12,346'",
        "812.5, 813",
        "-1234, '-1,234'",
        "100, 100",
        "99.996, 100",
        "12.0004, 12",
        "0.95, 0.95",
        "0.98765, 0.9877",
        "0, 0",
        "-3.5, -3.5",
        "1e-10, 1.000e-10",
        "999999999, '999,999,999'",
        "1e9, 1e+09",
        "1e17, 1e+17",
        "-1.25e17, -1.25e+17",
        "1.7976931348623157e308, 1.798e+308",
        "NaN, -"
    })
    void score_hasGroupsIfLarge_andNoMoreDigitsThanItNeedsIfSmall(double value, String text) {
        assertThat(Numbers.score(value)).isEqualTo(text);
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "0.5, 0.500", "0.0432, 0.0432", "0.00054, 0.00054", "0.000004, 4.0e-06", "NaN, -"})
    void probability_hasTwoOrThreeDigits(double value, String text) {
        assertThat(Numbers.probability(value)).isEqualTo(text);
    }
}
