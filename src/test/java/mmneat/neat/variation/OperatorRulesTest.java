package mmneat.neat.variation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;

/** Rules of the operators that the recorded cases of the original do not cover. */
class OperatorRulesTest {

    private static final int INPUTS = 3;

    private final ResumableRandom random = new ResumableRandom(7);

    @Test
    void networkOfOneModule_getsTwoPreferenceNeurons_withItsSecondModule() {
        Genotype before = new InitialNetworks(INPUTS, ModuleLayout.single(1)).create(0, random);
        for (MutationOperator operator : List.of(
                new ModuleDuplication(ActivationFunction.TANH),
                new PreviousModuleMutation(ActivationFunction.TANH),
                new RandomModuleMutation(InputSelection.ALL, ActivationFunction.TANH),
                new FullModuleMutation(ActivationFunction.TANH))) {
            Genotype after = apply(operator, before);
            assertThat(after.modules()).as(operator.logName()).isEqualTo(2);
            assertThat(after.outputs()).as(operator.logName()).isEqualTo(4);
            assertThat(after.layout().hasPreferenceNeurons()).isTrue();
        }
    }

    @Test
    void duplicatedModule_leavesInactiveLinksBehind() {
        Genotype network = new InitialNetworks(INPUTS, ModuleLayout.withPreferenceNeurons(1, 1)).create(0, random);
        List<LinkGene> links = new ArrayList<>(network.links());
        long policy = network.nodes().get(network.firstOutput()).innovation();
        int first = 0;
        while (links.get(first).target() != policy) {
            first++;
        }
        links.set(first, links.get(first).withActive(false));
        Genotype before = withLinks(network, links);

        Genotype after = apply(new ModuleDuplication(ActivationFunction.TANH), before);

        long copy = after.nodes()
                .get(after.firstOutput() + after.layout().policyOutput(1, 0))
                .innovation();
        Set<Long> sources = new HashSet<>();
        after.links().stream().filter(link -> link.target() == copy).forEach(link -> sources.add(link.source()));
        Set<Long> expected = new HashSet<>();
        links.stream()
                .filter(link -> link.target() == policy && link.active())
                .forEach(link -> expected.add(link.source()));
        assertThat(sources).isEqualTo(expected).hasSize(INPUTS - 1);
    }

    @Test
    void gate_isOpenAtExactlyTheShareAskedFor_andClosedBelow() {
        ModuleGate gate = new ModuleGate(1000, 10);
        assertThat(gate.isOpen(2, new int[] {1, 19})).as("5 %").isTrue();
        assertThat(gate.isOpen(2, new int[] {1, 20})).as("less").isFalse();
        assertThat(gate.isOpen(2, new int[] {0, 0})).as("never asked").isFalse();
    }

    @Test
    void newLink_mayLeadToAHiddenNeuronWhoseOnlyOutgoingLinkIsInactive() {
        Genotype network = new InitialNetworks(INPUTS, ModuleLayout.single(1)).create(0, random);
        GenePool pool = GenePool.foundedOn(network);
        long hidden = pool.takeInnovation();
        List<NodeGene> nodes = new ArrayList<>(network.nodes());
        nodes.add(INPUTS, new NodeGene(hidden, NodeType.HIDDEN, ActivationFunction.TANH));
        List<LinkGene> links = new ArrayList<>(network.links());
        long output = nodes.get(INPUTS + 1).innovation();
        links.add(new LinkGene(pool.takeInnovation(), hidden, output, 1, false).withActive(false));
        Genotype before = new Genotype(0, INPUTS, network.layout(), nodes, links, new int[1]);

        Set<Long> targets = new HashSet<>();
        for (int i = 0; i < 100; i++) {
            GenotypeDraft draft = GenotypeDraft.of(before);
            new NewLinkMutation().apply(draft, pool, random);
            draft.links().stream().skip(links.size()).forEach(link -> targets.add(link.target()));
        }
        assertThat(targets).containsExactlyInAnyOrder(hidden, output);
    }

    @Test
    void moduleMutations_comeInTheOriginalsOrder() {
        Genotype network = new InitialNetworks(INPUTS, ModuleLayout.withPreferenceNeurons(2, 1))
                .create(0, random)
                .withModuleUsage(new int[] {50, 50});
        MutationRates always = new MutationRates(
                0,
                0,
                0,
                0,
                new MutationRates.ModuleRates(1, 1, 1, 1),
                MutationRates.DeletionRates.NONE,
                MutationRates.FreezingRates.NONE);
        GenotypeDraft draft = GenotypeDraft.of(network);
        List<String> performed =
                new OffspringMutation(new VariationSettings(always)).apply(draft, GenePool.foundedOn(network), random);
        assertThat(performed).containsExactly("MMP", "MMR", "MMD", "FullMM");
    }

    private Genotype apply(MutationOperator operator, Genotype before) {
        GenotypeDraft draft = GenotypeDraft.of(before);
        assertThat(operator.apply(draft, GenePool.foundedOn(before), random)).isTrue();
        return draft.finish();
    }

    private static Genotype withLinks(Genotype network, List<LinkGene> links) {
        return new Genotype(
                network.id(), network.inputs(), network.layout(), network.nodes(), links, network.moduleUsage());
    }
}
