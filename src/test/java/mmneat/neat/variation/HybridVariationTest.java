package mmneat.neat.variation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;

/** Operators on networks whose modules are in groups. */
class HybridVariationTest {

    private static final int INPUTS = 5;

    private final ResumableRandom random = new ResumableRandom(17);

    private Genotype network(int... sizes) {
        return new InitialNetworks(INPUTS, ModuleLayout.grouped(1, sizes)).create(1, random);
    }

    private static MutationOperator duplication() {
        return new ModuleDuplication(mmneat.neat.ActivationFunction.TANH);
    }

    /** Sources and weights of the links into a module's policy neuron. */
    private static Set<String> incoming(Genotype network, int module) {
        long target = network.nodes()
                .get(network.firstOutput() + network.layout().policyOutput(module, 0))
                .innovation();
        Set<String> links = new HashSet<>();
        for (LinkGene link : network.links()) {
            if (link.target() == target) {
                links.add(link.source() + " " + link.weight());
            }
        }
        return links;
    }

    @Test
    void duplicatedModule_isOfTheGroupOfItsOriginal() {
        Set<Integer> groups = new HashSet<>();
        for (int i = 0; i < 50; i++) {
            Genotype parent = network(2, 1);
            GenotypeDraft draft = GenotypeDraft.copyOf(parent, 2);
            assertThat(duplication().apply(draft, GenePool.foundedOn(parent), random))
                    .isTrue();
            Genotype child = draft.finish();

            assertThat(child.layout().groups().subList(0, 3)).containsExactly(0, 0, 1);
            int group = child.layout().groups().get(3);
            assertThat(List.of(0, 1, 2))
                    .filteredOn(module -> incoming(child, module).equals(incoming(child, 3)))
                    .hasSize(1)
                    .allMatch(module -> child.layout().groups().get(module) == group);
            groups.add(group);
        }
        assertThat(groups).containsExactlyInAnyOrder(0, 1);
    }

    @Test
    void deletion_leavesEachGroupAModule() {
        for (int i = 0; i < 50; i++) {
            Genotype parent = network(2, 1);
            GenePool pool = GenePool.foundedOn(parent);
            GenotypeDraft draft = GenotypeDraft.copyOf(parent, 2);
            MutationOperator deletion = new DeleteModuleMutation(i % 2 == 0);
            assertThat(deletion.apply(draft, pool, random)).isTrue();
            assertThat(draft.finish().layout().groups()).containsExactly(0, 1);
            assertThat(deletion.apply(draft, pool, random)).isFalse();
        }
    }

    /** Two parents whose last modules stand at one place, but in different groups. */
    @Test
    void crossover_swapsNoGenesBetweenModulesOfDifferentGroups() {
        Genotype start = network(1, 1);
        GenePool pool = GenePool.foundedOn(start);
        Genotype first = grown(start, 0, pool);
        Genotype second = grown(start, 1, pool);
        int swapped = 0;
        for (int i = 0; i < 50; i++) {
            GenotypeDraft a = GenotypeDraft.copyOf(first, 10);
            GenotypeDraft b = GenotypeDraft.copyOf(second, 11);
            new Crossover(0).cross(a, b, pool.archetype(), random);
            Genotype childOfFirst = a.finish();
            Genotype childOfSecond = b.finish();
            assertThat(childOfFirst.layout()).isEqualTo(first.layout());
            assertThat(childOfSecond.layout()).isEqualTo(second.layout());
            assertThat(incoming(childOfFirst, 2)).isEqualTo(incoming(first, 2));
            assertThat(incoming(childOfSecond, 2)).isEqualTo(incoming(second, 2));
            swapped += incoming(childOfFirst, 0).equals(incoming(first, 0)) ? 0 : 1;
        }
        assertThat(swapped).isGreaterThan(40);
    }

    /** A network with new weights and a copy of a module of a group. */
    private Genotype grown(Genotype start, int group, GenePool pool) {
        while (true) {
            GenotypeDraft draft = GenotypeDraft.copyOf(start, pool.takeGenotypeId());
            draft.links().replaceAll(link -> link.withWeight(random.nextGaussian()));
            duplication().apply(draft, pool, random);
            if (draft.layout().groups().get(2) == group) {
                return draft.finish();
            }
        }
    }

    @Test
    void networksWithDifferentGroups_areNotCrossed() {
        Genotype first = network(2, 1);
        Reproduction reproduction =
                new Reproduction(new VariationSettings(MutationRates.PUBLISHED), GenePool.foundedOn(first));
        assertThatThrownBy(() -> reproduction.fromTwo(first, network(1, 1, 1), 2, random))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("parents must have equally many groups of modules, have 2 and 3");
    }

    @Test
    void layout_knowsTheSizesOfItsGroups() {
        ModuleLayout layout = new ModuleLayout(10, 5, 1, false, List.of(1, 0, 1, 2, 1));
        assertThat(layout.sizesOfGroups()).containsExactly(1, 3, 1);
        assertThat(layout.choicesOfTask()).isEqualTo(3);
        assertThat(layout.choiceOf(4)).isEqualTo(1);
        assertThat(ModuleLayout.grouped(1, 1, 3, 1).groups()).containsExactly(0, 1, 1, 1, 2);
    }

    @Test
    void layoutsWithoutAModuleInEachGroup_areRefused() {
        assertThatThrownBy(() -> new ModuleLayout(4, 2, 1, false, List.of(0, 2)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("groups: each from 0 to 2 must have a module, are [0, 2]");
        assertThatThrownBy(() -> new ModuleLayout(4, 2, 1, false, List.of(0)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("for each of 2 modules");
        assertThatThrownBy(() -> new ModuleLayout(4, 2, 1, false, List.of(0, -1)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("must not be negative");
        assertThatThrownBy(() -> new ModuleLayout(2, 2, 1, true, List.of(0, 1)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("preference neurons");
    }
}
