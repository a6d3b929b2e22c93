package mmneat.neat.variation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import mmneat.neat.network.Network;
import mmneat.neat.network.NetworkState;
import mmneat.neat.network.SampleGenotypes;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;

class DeleteModuleMutationTest {

    private static final int MODULES = 3;

    private final SplittableRandom random = new SplittableRandom(1);
    private final ResumableRandom draws = new ResumableRandom(2);

    @Test
    void leastUsedModule_isRemoved_andTheOthersKeepTheirOutputs() {
        for (int i = 0; i < 100; i++) {
            int least = i % MODULES;
            Genotype before = withUsage(threeModules(), least);
            Genotype after = delete(new DeleteModuleMutation(true), before);

            assertThat(after.modules()).isEqualTo(MODULES - 1);
            assertThat(after.outputs())
                    .isEqualTo(before.outputs() - before.layout().neuronsPerModule());
            assertThat(after.moduleUsage())
                    .containsExactly(
                            before.layout().modules() * 10, before.layout().modules() * 10);
            assertEqualAnswers(before, after, least);
        }
    }

    @Test
    void firstOfTheLeastUsedModules_isRemoved() {
        for (int[] usage : new int[][] {{5, 1, 1}, {5, 5, 5}, {2, 9, 2}}) {
            Genotype before = threeModules().withModuleUsage(usage);
            Genotype after = delete(new DeleteModuleMutation(true), before);
            assertEqualAnswers(before, after, usage[0] == 5 && usage[1] == 1 ? 1 : 0);
        }
    }

    @Test
    void outputsThatMove_takeTheirGenesAlong() {
        Genotype grown = threeModules();
        List<NodeGene> nodes = new ArrayList<>(grown.nodes());
        int lastPolicy = grown.firstOutput() + grown.layout().policyOutput(MODULES - 1, 0);
        long innovation = nodes.get(lastPolicy).innovation();
        nodes.set(lastPolicy, new NodeGene(innovation, NodeType.OUTPUT, ActivationFunction.IDENTITY, true, false));
        Genotype before = new Genotype(0, grown.inputs(), grown.layout(), nodes, grown.links(), new int[] {0, 1, 1});

        Genotype after = delete(new DeleteModuleMutation(true), before);

        for (int output = 0; output < after.outputs(); output++) {
            NodeGene node = after.nodes().get(after.firstOutput() + output);
            boolean isMoved = output == after.layout().policyOutput(MODULES - 2, 0);
            assertThat(node.frozen()).isEqualTo(isMoved);
            assertThat(node.activation()).isEqualTo(isMoved ? ActivationFunction.IDENTITY : ActivationFunction.TANH);
        }
    }

    @Test
    void randomModule_takesOneDraw_andEachModuleHasItsTurn() {
        Set<Integer> deleted = new HashSet<>();
        for (int i = 0; i < 60; i++) {
            Genotype before = threeModules();
            int expected = draws.copy().nextInt(MODULES);
            Genotype after = delete(new DeleteModuleMutation(false), before);
            assertEqualAnswers(before, after, expected);
            deleted.add(expected);
        }
        assertThat(deleted).containsExactlyInAnyOrder(0, 1, 2);
    }

    @Test
    void innovations_keepNamingOnePairOfNeurons() {
        for (int i = 0; i < 100; i++) {
            Genotype before = threeModules();
            Genotype after = delete(new DeleteModuleMutation(false), before);
            for (LinkGene link : after.links()) {
                for (LinkGene old : before.links()) {
                    if (old.innovation() == link.innovation()) {
                        assertThat(link.source()).isEqualTo(old.source());
                        assertThat(link.target()).isEqualTo(old.target());
                    }
                }
            }
        }
    }

    @Test
    void singleModules_andMultitaskNetworks_areNotChanged() {
        for (ModuleLayout layout : List.of(ModuleLayout.single(1), ModuleLayout.multitask(2, 1))) {
            Genotype genotype = SampleGenotypes.grown(random, 5, layout, 3, 20);
            GenotypeDraft draft = GenotypeDraft.of(genotype);
            assertThat(new DeleteModuleMutation(true).apply(draft, GenePool.foundedOn(genotype), draws))
                    .isFalse();
            assertThat(draft.finish().links()).isEqualTo(genotype.links());
        }
    }

    private Genotype delete(DeleteModuleMutation mutation, Genotype before) {
        GenotypeDraft draft = GenotypeDraft.of(before);
        assertThat(mutation.apply(draft, GenePool.foundedOn(before), draws)).isTrue();
        return draft.finish();
    }

    /**
     * Three modules with a policy and a preference neuron each; outputs have no outgoing links, so modules do not
     * depend on each other.
     */
    private Genotype threeModules() {
        Genotype grown = SampleGenotypes.grown(random, 6, SampleGenotypes.withPreference(MODULES), 8, 60);
        Set<Long> outputs = new HashSet<>();
        grown.nodes()
                .subList(grown.firstOutput(), grown.nodes().size())
                .forEach(node -> outputs.add(node.innovation()));
        List<LinkGene> links = grown.links().stream()
                .filter(link -> !outputs.contains(link.source()))
                .toList();
        return new Genotype(0, grown.inputs(), grown.layout(), grown.nodes(), links, grown.moduleUsage());
    }

    private static Genotype withUsage(Genotype genotype, int least) {
        int[] usage = new int[genotype.modules()];
        java.util.Arrays.fill(usage, 10 * genotype.modules());
        usage[least] = 1;
        return new Genotype(0, genotype.inputs(), genotype.layout(), genotype.nodes(), genotype.links(), usage);
    }

    private void assertEqualAnswers(Genotype before, Genotype after, int deleted) {
        NetworkState full = Network.compile(before).newState();
        NetworkState reduced = Network.compile(after).newState();
        List<Integer> kept = new ArrayList<>(List.of(0, 1, 2));
        kept.remove(deleted);
        for (int step = 0; step < 10; step++) {
            double[] inputs = random.doubles(before.inputs(), -1, 1).toArray();
            full.activate(inputs, new ResumableRandom(1));
            reduced.activate(inputs, new ResumableRandom(1));
            for (int module = 0; module < kept.size(); module++) {
                assertThat(reduced.moduleOutput(module, 0)).isEqualTo(full.moduleOutput(kept.get(module), 0));
                assertThat(reduced.preference(module)).isEqualTo(full.preference(kept.get(module)));
            }
        }
    }
}
