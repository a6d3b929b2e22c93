package mmneat.neat.variation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Settings that the published experiments do not use: their effects, and the number of random draws they take. */
class VariationOptionsTest {

    private static final int INPUTS = 7;
    private static final MutationRates NO_CHANGE = withOneWeight(0);

    private final ResumableRandom random = new ResumableRandom(11);
    private final Genotype network =
            new InitialNetworks(INPUTS, ModuleLayout.withPreferenceNeurons(2, 1)).create(0, random);

    /** Rates that are all 0 except that of changing a single weight. */
    private static MutationRates withOneWeight(double rate) {
        return new MutationRates(
                0,
                0,
                0,
                rate,
                MutationRates.ModuleRates.NONE,
                MutationRates.DeletionRates.NONE,
                MutationRates.FreezingRates.NONE);
    }

    private static VariationSettings settings(MutationRates rates, InputSelection selection) {
        return new VariationSettings(rates, ModuleGate.PUBLISHED, 0, false, selection, ActivationFunction.TANH);
    }

    /** Mutates the network and counts the draws that decide whether an operator is applied. */
    private int drawsOf(VariationSettings settings, int[] usage) {
        ResumableRandom counted = random.copy();
        GenotypeDraft draft = GenotypeDraft.of(network.withModuleUsage(usage));
        List<String> performed = new OffspringMutation(settings).apply(draft, GenePool.foundedOn(network), counted);
        assertThat(performed).isEmpty();
        ResumableRandom expected = random.copy();
        int draws = 0;
        while (!expected.state().equals(counted.state())) {
            expected.nextDouble();
            draws++;
        }
        return draws;
    }

    @Test
    void everyOperatorOfRateZero_takesItsDraw() {
        assertThat(drawsOf(settings(NO_CHANGE, InputSelection.ALL), new int[] {50, 50}))
                .as("three of freezing, two of deletion, four of modules, splice, link, weight")
                .isEqualTo(12);
        assertThat(drawsOf(settings(NO_CHANGE, InputSelection.ALL), new int[] {0, 100}))
                .as("the same without modules: the gate is closed")
                .isEqualTo(8);
        assertThat(drawsOf(settings(NO_CHANGE, InputSelection.ALL), new int[] {100}))
                .as("usage of another number of modules leaves the gate open")
                .isEqualTo(12);
        assertThat(drawsOf(settings(NO_CHANGE, new InputSelection(true, 3)), new int[] {50, 50}))
                .as("feature selective networks are never given full modules: no draw for them")
                .isEqualTo(11);
    }

    @Test
    void networkOfAllModulesAllowed_gainsNone() {
        assertThat(new ModuleGate(2, 10).isOpen(1, new int[] {100})).isTrue();
        assertThat(new ModuleGate(2, 10).isOpen(2, new int[] {50, 50})).isFalse();
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.0, -0.0})
    void usageForNewModeOfZero_asksForAnInfiniteShare_andClosesTheGate(double zero) {
        assertThat(new ModuleGate(1000, zero).isOpen(1, new int[] {100})).isFalse();
        assertThat(new ModuleGate(1000, zero).isOpen(2, new int[] {50, 50})).isFalse();
    }

    @Test
    void usageOfAnotherNumberOfModules_opensTheGate() {
        ModuleGate gate = ModuleGate.PUBLISHED;
        assertThat(gate.isOpen(3, new int[] {100, 0})).isTrue();
        assertThat(gate.isOpen(2, new int[] {0, 0, 0})).isTrue();
        assertThat(gate.isOpen(2, new int[0])).isTrue();
        assertThat(gate.isOpen(2, new int[] {100, 0})).isFalse();
        assertThat(gate.isOpen(3, new int[] {0, 0, 0})).isFalse();
    }

    @Test
    void frozenLinks_arePassedOver_withoutADraw() {
        GenotypeDraft draft = GenotypeDraft.of(network);
        for (int i = 0; i < draft.links().size(); i += 2) {
            draft.links().set(i, draft.links().get(i).withFrozen(true));
        }
        List<LinkGene> expected = new ArrayList<>(draft.links());
        ResumableRandom expectedDraws = random.copy();
        for (int i = 1; i < expected.size(); i += 2) {
            LinkGene link = expected.get(i);
            if (expectedDraws.nextDouble() < 0.5) {
                expected.set(i, link.withWeight(link.weight() + expectedDraws.nextGaussian()));
            }
        }

        new AllWeightMutation(0.5).apply(draft, GenePool.foundedOn(network), random);

        assertThat(draft.links()).isEqualTo(expected);
        assertThat(random.state()).isEqualTo(expectedDraws.state());
    }

    @Test
    void selectiveStart_shufflesTheInputs_andDrawsWeightsInTheirOrder() {
        InputSelection three = new InputSelection(true, 3);
        ModuleLayout layout = ModuleLayout.multitask(2, 1);
        InitialNetworks networks = new InitialNetworks(INPUTS, layout, three, ActivationFunction.TANH);
        for (int seed = 0; seed < 20; seed++) {
            Random plain = new Random(seed);
            Map<String, Double> expected = new HashMap<>();
            for (int output = 0; output < 2; output++) {
                List<Integer> inputs = new ArrayList<>(List.of(0, 1, 2, 3, 4, 5, 6));
                Collections.shuffle(inputs, plain);
                for (int input : inputs.subList(0, 3)) {
                    expected.put((-1 - input) + " to " + (-1 - INPUTS - output), plain.nextDouble() * 2 - 1);
                }
            }

            Genotype selective = networks.create(0, new ResumableRandom(seed));

            Map<String, Double> weights = new HashMap<>();
            selective.links().forEach(link -> weights.put(link.source() + " to " + link.target(), link.weight()));
            assertThat(weights).isEqualTo(expected);
        }
    }

    @Test
    void selectiveStart_linksEachPolicyNeuronToSoManyDifferentInputs() {
        InputSelection three = new InputSelection(true, 3);
        InitialNetworks networks =
                new InitialNetworks(INPUTS, ModuleLayout.withPreferenceNeurons(2, 1), three, ActivationFunction.TANH);
        int[] timesLinked = new int[INPUTS];
        for (int i = 0; i < 500; i++) {
            Genotype selective = networks.create(i, random);
            for (int output = 0; output < 4; output++) {
                long target = selective.nodes().get(INPUTS + output).innovation();
                long[] sources = selective.links().stream()
                        .filter(link -> link.target() == target)
                        .mapToLong(LinkGene::source)
                        .distinct()
                        .toArray();
                assertThat(sources).hasSize(selective.layout().isPreference(output) ? 1 : 3);
                for (long source : sources) {
                    timesLinked[(int) -source - 1]++;
                }
            }
        }
        assertThat(timesLinked).as("8 of 28 links a network, 4,000 in all").doesNotContain(0);
        assertThatThrownBy(() -> new InitialNetworks(
                        INPUTS, ModuleLayout.single(1), new InputSelection(true, 8), ActivationFunction.TANH))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("a policy neuron cannot be linked to 8 of 7 inputs");
    }

    @Test
    void withoutRatePerLink_oneWeightChanges() {
        GenotypeDraft draft = GenotypeDraft.of(network.withModuleUsage(new int[] {0, 100}));

        List<String> performed = new OffspringMutation(settings(withOneWeight(1), InputSelection.ALL))
                .apply(draft, GenePool.foundedOn(network), random);

        assertThat(performed).hasSize(1);
        List<LinkGene> links = draft.finish().links();
        long changed = 0;
        for (int i = 0; i < links.size(); i++) {
            changed += links.get(i).equals(network.links().get(i)) ? 0 : 1;
        }
        assertThat(changed).isEqualTo(1);
    }
}
