package mmneat.neat.network;

import static org.assertj.core.api.Assertions.assertThat;

import mmneat.neat.ActivationFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FunctionsTest {

    @ParameterizedTest
    @ValueSource(doubles = {-6.999, -1, 0, 0.5, 6.999})
    void logistic_isExact_below7(double sum) {
        assertThat(Functions.of(ActivationFunction.LOGISTIC, sum)).isEqualTo(1 / (1 + StrictMath.exp(-sum)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {7, 7.001, 7.5, 40, 1e300, Double.POSITIVE_INFINITY})
    void logistic_staysWhereItIsAt7_beyond(double sum) {
        assertThat(Functions.of(ActivationFunction.LOGISTIC, sum)).isEqualTo(1 / (1 + StrictMath.exp(-7)));
        assertThat(Functions.of(ActivationFunction.LOGISTIC, -sum)).isEqualTo(1 / (1 + StrictMath.exp(7)));
    }

    @Test
    void identity_isTheSum() {
        assertThat(Functions.of(ActivationFunction.IDENTITY, -12.25)).isEqualTo(-12.25);
    }
}
