package mmneat.neat;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import mmneat.neat.variation.InitialNetworks;
import mmneat.neat.variation.MutationRates;
import mmneat.neat.variation.Offspring;
import mmneat.neat.variation.RandomLineages;
import mmneat.neat.variation.Reproduction;
import mmneat.neat.variation.VariationSettings;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;

class GenePoolTest {

    private static final VariationSettings SETTINGS =
            new VariationSettings(MutationRates.PUBLISHED.withModuleDuplication(0.3));

    @Test
    void resumedPool_continuesExactly() {
        RandomLineages lineages =
                new RandomLineages(new InitialNetworks(4, ModuleLayout.withPreferenceNeurons(1, 1)), SETTINGS, 6, 3);
        lineages.reproduce(60, child -> assertThat(child.genotype()).isNotNull());
        GenePool.State state = lineages.pool().state();
        Genotype parent = lineages.population().get(0);
        Genotype other = lineages.population().get(1);

        List<List<Offspring>> continuations = new ArrayList<>();
        List<GenePool.State> ends = new ArrayList<>();
        for (int i = 0; i < 2; i++) {
            GenePool pool = GenePool.resume(state);
            Reproduction reproduction = new Reproduction(SETTINGS, pool);
            ResumableRandom random = new ResumableRandom(17);
            List<Offspring> children = new ArrayList<>();
            for (int j = 0; j < 20; j++) {
                children.addAll(reproduction.fromTwo(parent, other, 2, random));
                children.add(reproduction.fromOne(parent, random));
            }
            continuations.add(children);
            ends.add(pool.state());
        }

        assertThat(continuations.get(0)).isEqualTo(continuations.get(1)).hasSize(60);
        assertThat(ends.get(0)).isEqualTo(ends.get(1)).isNotEqualTo(state);
    }

    @Test
    void childrenOfTwo_takeThreeIds_andTheSecondParentsStructureComesFirst() {
        InitialNetworks networks = new InitialNetworks(4, ModuleLayout.single(1));
        ResumableRandom random = new ResumableRandom(1);
        GenePool pool = GenePool.foundedOn(networks.create(-1, random));
        List<Genotype> parents = networks.createPopulation(2, pool, random);
        Reproduction reproduction = new Reproduction(SETTINGS, pool);

        List<Offspring> children = reproduction.fromTwo(parents.get(0), parents.get(1), 2, random);

        assertThat(children).extracting(child -> child.genotype().id()).containsExactly(5L, 3L);
        assertThat(children).extracting(Offspring::firstParent).containsOnly(1L);
        assertThat(children)
                .extracting(child -> child.secondParent().orElseThrow())
                .containsOnly(2L);
    }

    @Test
    void crossoverWithRoomForOne_keepsTheFirstParentsStructure_andSkipsIds() {
        InitialNetworks networks = new InitialNetworks(4, ModuleLayout.single(1));
        ResumableRandom random = new ResumableRandom(1);
        GenePool pool = GenePool.foundedOn(networks.create(-1, random));
        List<Genotype> parents = networks.createPopulation(2, pool, random);
        Reproduction reproduction = new Reproduction(SETTINGS, pool);

        List<Offspring> children = reproduction.fromTwo(parents.get(0), parents.get(1), 1, random);

        assertThat(children).extracting(child -> child.genotype().id()).containsExactly(3L);
        assertThat(pool.takeGenotypeId()).isEqualTo(6);
    }

    @Test
    void cleaning_removesUnusedEntries_andShadowsWithTheirNeurons() {
        RandomLineages lineages = new RandomLineages(new InitialNetworks(4, ModuleLayout.single(1)), SETTINGS, 6, 3);
        lineages.reproduce(24, child -> assertThat(child.genotype()).isNotNull());
        Archetype archetype = lineages.pool().archetype();
        assertThat(archetype.shadows()).isNotEmpty();

        Genotype survivor = new InitialNetworks(4, ModuleLayout.single(1)).create(0, new ResumableRandom(1));
        archetype.clean(List.of(survivor));

        assertThat(archetype.entries()).isEqualTo(survivor.nodes());
        assertThat(archetype.shadows()).isEmpty();
    }
}
