package mmneat.neat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import mmneat.neat.io.GenotypeJson;
import mmneat.neat.io.GenotypeXml;
import mmneat.neat.network.Network;
import mmneat.neat.variation.InitialNetworks;
import mmneat.neat.variation.InputSelection;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Activation functions of the user's own, in genotypes and in their files. */
class ActivationFunctionTest {

    private static final ActivationFunction SINE = ActivationFunction.own("my.Sine", StrictMath::sin);

    /** A function with a class of its own. */
    private static final class Half implements NeuronFunction {
        @Override
        public double of(double sum) {
            return sum / 2;
        }
    }

    private static Genotype network(ActivationFunction function) {
        return new InitialNetworks(3, ModuleLayout.withPreferenceNeurons(2, 1), InputSelection.ALL, function)
                .create(7, new ResumableRandom(1));
    }

    private static double output(Genotype genotype) {
        var state = Network.compile(genotype).newState();
        state.activate(new double[] {0.5, -0.25, 1}, new ResumableRandom(0));
        return state.policyOutput(0);
    }

    @Test
    void ownFunction_isKnownByItsName() {
        assertThat(SINE).isEqualTo(ActivationFunction.ofClass("my.Sine")).hasToString("my.Sine");
        assertThat(SINE).isNotEqualTo(ActivationFunction.ofClass("my.Cosine"));
        assertThat(SINE).isNotEqualTo(ActivationFunction.TANH);
        assertThat(ActivationFunction.own(new Half()).name()).isEqualTo(Half.class.getName());
        assertThat(ActivationFunction.ofClass("tanh")).isNotEqualTo(ActivationFunction.TANH);
        assertThatIllegalArgumentException().isThrownBy(() -> ActivationFunction.own(sum -> sum));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "two words", "a\"b", "<a>", "a/b", "a\nb", "a\u0000b"})
    void textThatIsNoClassName_isRefused(String name) {
        assertThatIllegalArgumentException().isThrownBy(() -> ActivationFunction.ofClass(name));
    }

    @Test
    void files_holdTheName_andTheNetworkIsBoundAgain() throws IOException {
        Genotype network = network(SINE);
        double before = output(network);
        for (Genotype read : new Genotype[] {
            GenotypeJson.read(GenotypeJson.write(network)), GenotypeXml.read(GenotypeXml.write(network))
        }) {
            assertThat(read).isEqualTo(network);
            assertThat(read.unboundFunctions()).containsExactly("my.Sine");
            assertThatThrownBy(() -> Network.compile(read))
                    .isInstanceOf(BadPartException.class)
                    .hasMessage("activation function my.Sine: its class has not been loaded");

            Genotype bound = read.withFunctions(function -> SINE);
            assertThat(bound.unboundFunctions()).isEmpty();
            assertThat(output(bound)).isEqualTo(before);
        }
        assertThat(GenotypeJson.write(network)).contains("\"activation\" : \"class:my.Sine\"");
    }

    @Test
    void functionThatFails_isNamed() {
        assertThatThrownBy(() -> output(network(ActivationFunction.own("my.Bad", sum -> 0 * sum / 0))))
                .isInstanceOf(BadPartException.class)
                .hasMessage("activation function my.Bad: gave NaN for the sum 0.5; it must give a finite number");
        assertThatThrownBy(() -> output(network(ActivationFunction.own("my.Thrower", sum -> {
                    throw new IllegalStateException("no such sum");
                }))))
                .isInstanceOf(BadPartException.class)
                .hasMessageStartingWith(
                        "activation function my.Thrower: threw java.lang.IllegalStateException: no such sum"
                                + " at mmneat.neat.ActivationFunctionTest.")
                .hasMessageNotContaining("\n");
    }
}
