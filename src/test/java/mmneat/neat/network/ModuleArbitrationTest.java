package mmneat.neat.network;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The ways of choosing and combining modules that the published experiments do not use. */
class ModuleArbitrationTest {

    private static final int DRAWS = 20_000;
    private static final double[] ONE = {1};

    private final ResumableRandom random = new ResumableRandom(4);

    /** One input of activation 1; the outputs' activations are the given values. */
    private static NetworkState state(ModuleLayout layout, ModuleArbitration arbitration, double... outputs) {
        List<NodeGene> nodes = new ArrayList<>();
        List<LinkGene> links = new ArrayList<>();
        nodes.add(new NodeGene(-1, NodeType.INPUT, ActivationFunction.IDENTITY));
        for (int i = 0; i < outputs.length; i++) {
            nodes.add(new NodeGene(-2 - i, NodeType.OUTPUT, ActivationFunction.IDENTITY));
            links.add(new LinkGene(i, -1, -2 - i, outputs[i], false));
        }
        Genotype genotype = new Genotype(0, 1, layout, nodes, links, new int[layout.modules()]);
        return Network.compile(genotype).newState(arbitration);
    }

    private static NetworkState threeModules(ModuleArbitration arbitration) {
        return state(SampleGenotypes.withPreference(3), arbitration, 10, 0.5, 20, 0.25, 30, 0.75);
    }

    @Test
    void softmax_choosesInProportionToTheExponentialOfPreference() {
        NetworkState state = threeModules(ModuleArbitration.PREFERENCE.withSoftmax(0.25));
        for (int i = 0; i < DRAWS; i++) {
            state.activate(ONE, random);
        }
        double total = Math.exp(2) + Math.exp(1) + Math.exp(3);
        double[] expected = {Math.exp(2) / total, Math.exp(1) / total, Math.exp(3) / total};
        for (int module = 0; module < 3; module++) {
            double share = expected[module];
            assertThat(state.moduleUsage()[module] / (double) DRAWS)
                    .isCloseTo(share, within(4 * Math.sqrt(share * (1 - share) / DRAWS)));
        }
    }

    @Test
    void disabledModule_isNotChosen() {
        NetworkState state = threeModules(ModuleArbitration.PREFERENCE.withDisabledModule(2));
        assertThat(state.activate(ONE, random)).isZero();
        assertThat(state.policyOutput(0)).isEqualTo(10);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1e-300})
    void softmax_nearTemperatureZero_choosesTheHighest_whateverItsSign(double temperature) {
        ModuleArbitration cold = ModuleArbitration.PREFERENCE.withSoftmax(temperature);
        for (double shift : new double[] {0, -2}) {
            NetworkState state = state(
                    SampleGenotypes.withPreference(3), cold, 10, 0.96 + shift, 20, 0.1 + shift, 30, -0.46 + shift);
            for (int i = 0; i < 100; i++) {
                assertThat(state.activate(ONE, random)).isZero();
            }
        }
    }

    @Test
    void disabledModule_thatANetworkLacks_disablesNothing() {
        NetworkState state = threeModules(ModuleArbitration.PREFERENCE.withDisabledModule(3));
        assertThat(state.activate(ONE, random)).isEqualTo(2);
    }

    @Test
    void fatigue_letsOthersTakeTurns_andFadesWhileResting() {
        NetworkState state = threeModules(ModuleArbitration.PREFERENCE.withFatigue(0.375, 0.5));
        // Compared: (.5, .25, .75); (.5, .25, .375); (.125, .25, .5625); (.3125, .25, .28125)
        assertThat(state.activate(ONE, random)).isEqualTo(2);
        assertThat(state.activate(ONE, random)).isZero();
        assertThat(state.activate(ONE, random)).isEqualTo(2);
        assertThat(state.activate(ONE, random)).isZero();
        state.flush();
        assertThat(state.activate(ONE, random)).as("rested").isEqualTo(2);
        assertThat(state.moduleUsage()).containsExactly(2, 0, 3);
    }

    @Test
    void weightedAverage_sumsAllModulesByPreference() {
        NetworkState state =
                threeModules(ModuleArbitration.PREFERENCE.withAnswer(ModuleArbitration.Answer.WEIGHTED_AVERAGE));
        state.activate(ONE, random);
        assertThat(state.policyOutput(0)).isEqualTo((0.5 * 10 + 0.25 * 20 + 0.75 * 30) / 3);
    }

    @Test
    void ensemble_averagesModulesWithoutPreferenceNeurons() {
        ModuleArbitration ensemble = ModuleArbitration.PREFERENCE.withAnswer(ModuleArbitration.Answer.ENSEMBLE);
        NetworkState state = state(new ModuleLayout(3, 3, 1, true), ensemble, 10, 20, 60);
        for (int i = 0; i < 100; i++) {
            state.activate(ONE, random);
        }
        assertThat(state.policyOutput(0)).isEqualTo(30);
        assertThat(state.moduleUsage()).as("all are equally preferred").doesNotContain(0);
        assertThatIllegalArgumentException().isThrownBy(() -> threeModules(ensemble));
    }

    @Test
    void hierarchicalMultitask_choosesAmongTheModulesOfThePresetTask() {
        NetworkState state = threeModules(ModuleArbitration.PREFERENCE.withTasks(0, 0, 1));
        assertThat(state.activateWithModule(ONE, 0, random)).isZero();
        assertThat(state.activateWithModule(ONE, 1, random)).isEqualTo(2);
    }

    @Test
    void hybrid_choosesByPreferenceWithinThePresetGroup() {
        ModuleLayout layout = new ModuleLayout(6, 3, 1, false, List.of(0, 1, 0));
        NetworkState state = state(layout, ModuleArbitration.PREFERENCE, 10, 0.5, 20, 0.9, 30, 0.75);
        assertThat(state.activateWithModule(ONE, 0, random)).isEqualTo(2);
        assertThat(state.policyOutput(0)).isEqualTo(30);
        assertThat(state.activateWithModule(ONE, 1, random)).isEqualTo(1);
        assertThat(state.policyOutput(0)).isEqualTo(20);
        assertThat(state.moduleUsage()).containsExactly(0, 1, 1);
        assertThatIllegalArgumentException().isThrownBy(() -> state.activateWithModule(ONE, 2, random));
    }

    @Test
    void hierarchicalMultitask_keepsToTheTask_alsoWhenTiredOrDrawing() {
        ModuleArbitration tasks = ModuleArbitration.PREFERENCE.withTasks(0, 0, 1);
        NetworkState tired = threeModules(tasks.withFatigue(5, 1));
        NetworkState drawing = threeModules(tasks.withSoftmax(10));
        for (int i = 0; i < 200; i++) {
            assertThat(tired.activateWithModule(ONE, 0, random)).isLessThan(2);
            assertThat(drawing.activateWithModule(ONE, 1, random)).isEqualTo(2);
        }
        NetworkState average = threeModules(tasks.withAnswer(ModuleArbitration.Answer.WEIGHTED_AVERAGE));
        average.activateWithModule(ONE, 0, random);
        assertThat(average.policyOutput(0)).isEqualTo((0.5 * 10 + 0.25 * 20) / 3);
    }

    @Test
    void plainArbitration_drawsOneInteger_softmaxOneDouble() {
        ResumableRandom expected = random.copy();
        threeModules(ModuleArbitration.PREFERENCE.withDisabledModule(0)).activate(ONE, random);
        expected.nextInt(1);
        assertThat(random.state()).isEqualTo(expected.state());
        threeModules(ModuleArbitration.PREFERENCE.withSoftmax(1)).activate(ONE, random);
        expected.nextDouble();
        assertThat(random.state()).isEqualTo(expected.state());
    }

    @Test
    void invalidSettings_areRefused() {
        ModuleArbitration plain = ModuleArbitration.PREFERENCE;
        assertThatIllegalArgumentException()
                .isThrownBy(() -> plain.withSoftmax(-1))
                .withMessageContaining("-1");
        assertThatIllegalArgumentException().isThrownBy(() -> plain.withSoftmax(Double.NaN));
        assertThatIllegalArgumentException().isThrownBy(() -> plain.withDisabledModule(-2));
        assertThatIllegalArgumentException().isThrownBy(() -> plain.withFatigue(Double.NaN, 1));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> threeModules(plain.withTasks(0, 0, 1)).presetModule(2))
                .withMessage("no module serves task 2, only [0, 0, 1]");
        assertThatIllegalArgumentException().isThrownBy(() -> threeModules(plain.withTasks(0, 1)));
    }

    @Test
    void missingParts_areNamed() {
        assertThatNullPointerException()
                .isThrownBy(() -> ModuleArbitration.PREFERENCE.withAnswer(null))
                .withMessage("answer");
        assertThatNullPointerException()
                .isThrownBy(() -> ModuleArbitration.PREFERENCE.withTasks((int[]) null))
                .withMessage("taskOfModule");
    }
}
