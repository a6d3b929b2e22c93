package mmneat.neat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.TreeMap;
import mmneat.neat.variation.InitialNetworks;
import mmneat.neat.variation.MutationRates;
import mmneat.neat.variation.Offspring;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;

/** Invalid genes, pools and settings are refused. */
class GenotypeTest {

    private final Genotype network =
            new InitialNetworks(2, ModuleLayout.withPreferenceNeurons(2, 1)).create(0, new ResumableRandom(1));

    @Test
    void shadowEntry_isNoNodeOfANetwork() {
        List<NodeGene> nodes = new ArrayList<>(network.nodes());
        nodes.set(3, new NodeGene(nodes.get(3).innovation(), NodeType.OUTPUT, ActivationFunction.TANH, false, true));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Genotype(0, 2, network.layout(), nodes, network.links(), new int[2]))
                .withMessage(
                        "nodes[3].fromCombiningCrossover: must be false, as it is only for entries of an archetype");
    }

    @Test
    void missingParts_areNamed() {
        assertMissing("layout", () -> new Genotype(0, 2, null, network.nodes(), network.links(), new int[2]));
        assertMissing("nodes", () -> new Genotype(0, 2, network.layout(), null, network.links(), new int[2]));
        assertMissing("links", () -> new Genotype(0, 2, network.layout(), network.nodes(), null, new int[2]));
        assertMissing(
                "moduleUsage", () -> new Genotype(0, 2, network.layout(), network.nodes(), network.links(), null));
        assertMissing("entries", () -> new Archetype.State(null, new TreeMap<>()));
        assertMissing("shadows", () -> new Archetype.State(List.of(), null));
        assertMissing("genotype", () -> new Offspring(null, 1, OptionalLong.empty(), List.of()));
        assertMissing("secondParent", () -> new Offspring(network, 1, null, List.of()));
        assertMissing("mutations", () -> new Offspring(network, 1, OptionalLong.empty(), null));
        MutationRates rates = MutationRates.PUBLISHED;
        assertMissing("module", () -> new MutationRates(0, 0, 0, 0, null, rates.deletion(), rates.freezing()));
        assertMissing("deletion", () -> new MutationRates(0, 0, 0, 0, rates.module(), null, rates.freezing()));
        assertMissing("freezing", () -> new MutationRates(0, 0, 0, 0, rates.module(), rates.deletion(), null));
    }

    private static void assertMissing(String name, Runnable making) {
        assertThatNullPointerException().isThrownBy(making::run).withMessage(name);
    }

    @Test
    void negativeInnovations_areNotHandedOut() {
        GenePool.State state = GenePool.foundedOn(network).state();
        assertThat(state.nextInnovation()).isZero();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new GenePool.State(-1, 1, state.archetype()))
                .withMessage("nextInnovation must not be negative, is -1");
    }

    @Test
    void negativePopulationSize_isRefused() {
        InitialNetworks networks = new InitialNetworks(2, network.layout());
        assertThatIllegalArgumentException()
                .isThrownBy(() -> networks.createPopulation(-1, GenePool.foundedOn(network), new ResumableRandom(1)))
                .withMessage("size of the population must not be negative, is -1");
    }

    @Test
    void outputsThatALayoutLacks_areRefused() {
        ModuleLayout layout = network.layout();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> layout.moduleOf(4))
                .withMessage("output must be 0 to 3, is 4");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> layout.isPreference(-1))
                .withMessage("output must be 0 to 3, is -1");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> ModuleLayout.single(1).preferenceOutput(0))
                .withMessage("the network has no preference neurons");
    }
}
