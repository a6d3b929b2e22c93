package mmneat.neat.variation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;

/** Crossover of parents whose outputs are in different order, as after full module mutation. */
class CrossoverTest {

    private static final int INPUTS = 3;
    private static final ModuleLayout LAYOUT = ModuleLayout.withPreferenceNeurons(2, 1);

    private final ResumableRandom random = new ResumableRandom(6);
    private final Genotype first = new InitialNetworks(INPUTS, LAYOUT).create(1, random);
    private final Genotype second = withModulesExchanged(first);
    private final GenePool pool = GenePool.foundedOn(first);

    /**
     * Returns the same network with the second module before the first. Its nodes are frozen, to distinguish them from
     * those of the other.
     */
    private static Genotype withModulesExchanged(Genotype genotype) {
        List<NodeGene> nodes = new ArrayList<>();
        for (NodeGene node : genotype.nodes()) {
            nodes.add(new NodeGene(node.innovation(), node.type(), node.activation(), true, false));
        }
        nodes.addAll(nodes.subList(INPUTS, INPUTS + 2).stream().toList());
        nodes.subList(INPUTS, INPUTS + 2).clear();
        return new Genotype(2, INPUTS, LAYOUT, nodes, genotype.links(), new int[2]);
    }

    private static List<Long> innovations(Genotype genotype) {
        return genotype.nodes().stream().map(NodeGene::innovation).toList();
    }

    @Test
    void sharedNeurons_arePairedByInnovation_andEachChildKeepsItsParentsOrder() {
        int swaps = 0;
        for (int i = 0; i < 200; i++) {
            GenotypeDraft a = GenotypeDraft.of(first);
            GenotypeDraft b = GenotypeDraft.of(second);

            new Crossover(0).cross(a, b, pool.archetype(), random);

            assertThat(innovations(a.finish())).isEqualTo(innovations(first));
            assertThat(innovations(b.finish())).isEqualTo(innovations(second));
            swaps += (int) a.nodes().stream().filter(NodeGene::frozen).count();
            assertThat(Stream.concat(a.nodes().stream(), b.nodes().stream()).filter(NodeGene::frozen))
                    .as("genes are exchanged, not copied")
                    .hasSize(first.nodes().size());
        }
        double fraction = swaps / (200.0 * first.nodes().size());
        assertThat(fraction).isBetween(0.44, 0.56);
    }

    @Test
    void sharedExcess_standsInTheArchetypesOrder_inBothChildren() {
        GenotypeDraft grown = GenotypeDraft.of(second);
        new FullModuleMutation(ActivationFunction.TANH).apply(grown, pool, random);
        Genotype third = grown.finish();
        GenotypeDraft a = GenotypeDraft.of(first);
        GenotypeDraft b = GenotypeDraft.of(third);

        new Crossover(1).cross(a, b, pool.archetype(), random);

        List<Long> all =
                pool.archetype().entries().stream().map(NodeGene::innovation).toList();
        assertThat(innovations(a.finish())).isEqualTo(all);
        assertThat(innovations(b.finish())).isEqualTo(all);
        assertThat(a.modules()).isEqualTo(3);
    }
}
