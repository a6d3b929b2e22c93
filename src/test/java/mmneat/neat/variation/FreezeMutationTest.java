package mmneat.neat.variation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.NodeGene;
import mmneat.neat.network.SampleGenotypes;
import mmneat.neat.variation.FreezeMutation.Part;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class FreezeMutationTest {

    private final SplittableRandom random = new SplittableRandom(4);
    private final ResumableRandom draws = new ResumableRandom(5);

    @ParameterizedTest
    @EnumSource(
            value = Part.class,
            names = {"POLICY", "PREFERENCE"})
    void chosenOutputsAndTheirUpstreamNeurons_areFrozen_andNothingElse(Part part) {
        for (int i = 0; i < 50; i++) {
            Genotype frozen = freeze(SampleGenotypes.young(random), part);
            Set<Long> expected = upstream(frozen, part == Part.PREFERENCE);
            for (NodeGene node : frozen.nodes()) {
                assertThat(node.frozen()).as("%s", node).isEqualTo(expected.contains(node.innovation()));
            }
            for (LinkGene link : frozen.links()) {
                assertThat(link.frozen()).as("%s", link).isEqualTo(expected.contains(link.target()));
            }
        }
    }

    @Test
    void alternating_freezesThePolicyFirst_thenThePreferences() {
        Genotype start = SampleGenotypes.young(random);
        Genotype first = freeze(start, Part.ALTERNATE);
        Genotype second = freeze(first, Part.ALTERNATE);
        assertThat(first.nodes()).isEqualTo(freeze(start, Part.POLICY).nodes());
        assertThat(second.nodes()).isEqualTo(freeze(start, Part.PREFERENCE).nodes());
        assertThat(freeze(second, Part.ALTERNATE).links()).isEqualTo(first.links());
    }

    @Test
    void frozenLinks_keepTheirWeights_andFrozenNeuronsGetNoNewLinks() {
        Genotype frozen = freeze(SampleGenotypes.young(random), Part.POLICY);
        GenePool pool = GenePool.foundedOn(frozen);
        Map<Long, LinkGene> before = new HashMap<>();
        frozen.links().forEach(link -> before.put(link.innovation(), link));
        Set<Long> frozenNodes = new HashSet<>();
        frozen.nodes().stream().filter(NodeGene::frozen).forEach(node -> frozenNodes.add(node.innovation()));
        GenotypeDraft draft = GenotypeDraft.of(frozen);
        boolean isAnyLinkNew = false;
        boolean isAnyWeightNew = false;
        for (int i = 0; i < 40; i++) {
            new AllWeightMutation(0.5).apply(draft, pool, draws);
            new NewLinkMutation().apply(draft, pool, draws);
        }
        for (LinkGene link : draft.finish().links()) {
            LinkGene old = before.get(link.innovation());
            if (old == null) {
                isAnyLinkNew = true;
                assertThat(frozenNodes).doesNotContain(link.target());
            } else if (old.frozen()) {
                assertThat(link.weight()).isEqualTo(old.weight());
            } else {
                isAnyWeightNew |= link.weight() != old.weight();
            }
        }
        assertThat(isAnyWeightNew).isTrue();
        assertThat(isAnyLinkNew).isTrue();
    }

    @Test
    void frozenLinks_areNotSpliced() {
        Genotype frozen = freeze(SampleGenotypes.young(random), Part.POLICY);
        GenePool pool = GenePool.foundedOn(frozen);
        GenotypeDraft draft = GenotypeDraft.of(frozen);
        int splices = 0;
        for (int i = 0; i < 100; i++) {
            splices += new SpliceNeuronMutation(ActivationFunction.TANH).apply(draft, pool, draws) ? 1 : 0;
        }
        Map<Long, LinkGene> after = new HashMap<>();
        draft.finish().links().forEach(link -> after.put(link.innovation(), link));
        assertThat(splices).isPositive();
        for (LinkGene link : frozen.links()) {
            if (link.frozen()) {
                assertThat(after.get(link.innovation())).isEqualTo(link);
            }
        }
    }

    private Genotype freeze(Genotype genotype, Part part) {
        GenotypeDraft draft = GenotypeDraft.of(genotype);
        assertThat(new FreezeMutation(part).apply(draft, GenePool.foundedOn(genotype), draws))
                .isTrue();
        return draft.finish();
    }

    /**
     * Returns the outputs of a kind and all neurons from which they can be reached without passing another output. It
     * repeats until nothing is added.
     */
    private static Set<Long> upstream(Genotype genotype, boolean preferences) {
        Set<Long> outputs = new HashSet<>();
        Set<Long> found = new HashSet<>();
        for (int output = 0; output < genotype.outputs(); output++) {
            long innovation =
                    genotype.nodes().get(genotype.firstOutput() + output).innovation();
            outputs.add(innovation);
            if (genotype.layout().isPreference(output) == preferences) {
                found.add(innovation);
            }
        }
        int before;
        do {
            before = found.size();
            for (LinkGene link : genotype.links()) {
                if (found.contains(link.target()) && !outputs.contains(link.source())) {
                    found.add(link.source());
                }
            }
        } while (found.size() > before);
        return found;
    }
}
