package mmneat.neat.variation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Archetype;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.io.GenotypeJson;
import mmneat.neat.io.GenotypeXml;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Thousands of random mutations and crossovers for each method. After each, all invariants of the genotype, the
 * archetype and their files are checked.
 */
class RandomChainTest {

    private static final int CHAINS = 10;
    private static final int REPRODUCTIONS = 150;

    private static final int MOST_MODULES = 6;

    /**
     * Settings with every operator at a high rate, including those that the published experiments do not use.
     *
     * @param moduleRate of MM(P), MM(R) and MM(D) each
     */
    private static VariationSettings everything(double moduleRate, double fullModuleRate, double excessRate) {
        return new VariationSettings(
                new MutationRates(
                        0.5,
                        0.3,
                        0.1,
                        0,
                        new MutationRates.ModuleRates(moduleRate, moduleRate, moduleRate, fullModuleRate),
                        new MutationRates.DeletionRates(0.2, 0.25),
                        new MutationRates.FreezingRates(0.02, 0.02, 0.05)),
                new ModuleGate(MOST_MODULES, 10),
                excessRate,
                false,
                InputSelection.ALL,
                ActivationFunction.TANH);
    }

    @ParameterizedTest
    @CsvSource({
        "1M,  7, 1, false, false, 0",
        "2M,  7, 2, true,  false, 0",
        "3M,  7, 3, true,  false, 0",
        "MMD, 7, 1, true,  false, 0.3",
        "MT,  6, 2, false, true,  0",
        "MT2, 7, 2, false, true,  0",
        "MT3, 7, 3, false, true,  0"
    })
    void everyOffspring_keepsTheInvariants_inEveryMethod(
            String method, int inputs, int modules, boolean preference, boolean multitask, double mmdRate) {
        ModuleLayout layout = multitask
                ? ModuleLayout.multitask(modules, 1)
                : preference ? ModuleLayout.withPreferenceNeurons(modules, 1) : ModuleLayout.single(1);
        VariationSettings settings = new VariationSettings(MutationRates.PUBLISHED.withModuleDuplication(mmdRate));
        for (int chain = 0; chain < CHAINS; chain++) {
            RandomLineages lineages =
                    new RandomLineages(new InitialNetworks(inputs, layout), settings, 8, 1000 + chain);
            Map<Long, String> structures = new HashMap<>();
            lineages.reproduce(REPRODUCTIONS, child -> {
                requireInvariants(child.genotype(), inputs, layout);
                requireModules(child, layout, mmdRate > 0);
                requireOutputsKnownByPosition(child.genotype());
                requirePartOf(child.genotype(), lineages.pool().archetype());
                requireOneMeaning(child.genotype(), structures);
                requireRoundTrip(child.genotype());
            });
            requireShadowsInArchetype(lineages.pool().archetype());
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "2, 1", "3, 2", "1, 3"})
    void everyOffspring_isANetwork_withEveryOperatorAtWork(int modules, int policyNeurons) {
        ModuleLayout layout = ModuleLayout.withPreferenceNeurons(modules, policyNeurons);
        Set<String> performed = new HashSet<>();
        for (int chain = 0; chain < CHAINS; chain++) {
            RandomLineages lineages =
                    new RandomLineages(new InitialNetworks(5, layout), everything(0.05, 0.05, 0.1), 8, 2000 + chain);
            Map<Long, String> structures = new HashMap<>();
            lineages.reproduce(REPRODUCTIONS, child -> {
                requireInvariants(child.genotype(), 5, layout);
                requireOneMeaning(child.genotype(), structures);
                requireRoundTrip(child.genotype());
                performed.addAll(child.mutations());
            });
        }
        assertThat(performed)
                .contains(
                        "MMP",
                        "MMR",
                        "MMD",
                        "FullMM",
                        "DeleteLinkMutation",
                        "DeleteModeMutation",
                        "FreezePolicyMutation",
                        "FreezePreferenceMutation",
                        "FreezeAlternateMutation",
                        "SpliceNeuronMutation",
                        "NewLinkMutation",
                        "AllWeightMutation");
    }

    @ParameterizedTest
    @CsvSource({
        "H21, 2, 1, 0, false",
        "H121, 3, 1, 0, false",
        "H21MMD, 2, 1, 0.3, false",
        "H21, 2, 2, 0, true",
        "H121, 3, 1, 0, true"
    })
    void everyOffspringOfHybrids_keepsItsGroups(
            String method, int groups, int policyNeurons, double mmdRate, boolean everything) {
        ModuleLayout layout =
                groups == 2 ? ModuleLayout.grouped(policyNeurons, 2, 1) : ModuleLayout.grouped(policyNeurons, 1, 2, 1);
        VariationSettings settings = everything
                ? everything(0.05, 0.05, 0.1)
                : new VariationSettings(MutationRates.PUBLISHED.withModuleDuplication(mmdRate));
        Set<List<Integer>> seen = new HashSet<>();
        for (int chain = 0; chain < CHAINS; chain++) {
            RandomLineages lineages = new RandomLineages(new InitialNetworks(6, layout), settings, 8, 6000 + chain);
            Map<Long, String> structures = new HashMap<>();
            lineages.reproduce(REPRODUCTIONS, child -> {
                ModuleLayout ofChild = child.genotype().layout();
                requireInvariants(child.genotype(), 6, layout);
                requireOneMeaning(child.genotype(), structures);
                requireRoundTrip(child.genotype());
                // The layout has checked that each group has a module and each module a group.
                requireEqual(ofChild.isGrouped(), true, "grouped");
                requireEqual(ofChild.choicesOfTask(), groups, "number of groups");
                if (!everything) {
                    requireModules(child, layout, mmdRate > 0);
                    requireOutputsKnownByPosition(child.genotype());
                    requirePartOf(child.genotype(), lineages.pool().archetype());
                }
                seen.add(ofChild.groups());
            });
        }
        if (everything || mmdRate > 0) {
            assertThat(seen).hasSizeGreaterThan(5);
        } else {
            assertThat(seen).containsExactly(layout.groups());
        }
    }

    /**
     * Full module mutation is the only operator that adds modules to the archetype in another order than to networks.
     */
    @Test
    void everyOffspring_isPartOfTheArchetype_withoutFullModuleMutation() {
        ModuleLayout layout = ModuleLayout.withPreferenceNeurons(2, 1);
        for (int chain = 0; chain < CHAINS; chain++) {
            RandomLineages lineages =
                    new RandomLineages(new InitialNetworks(5, layout), everything(0.1, 0, 0.3), 8, 3000 + chain);
            lineages.reproduce(REPRODUCTIONS, child -> {
                requireInvariants(child.genotype(), 5, layout);
                requirePartOf(child.genotype(), lineages.pool().archetype());
            });
            requireShadowsInArchetype(lineages.pool().archetype());
        }
    }

    @Test
    void fullModulesOfManyHistories_withExcessCrossoverAndDeletion_stayNetworks() {
        ModuleLayout layout = ModuleLayout.withPreferenceNeurons(2, 1);
        for (int chain = 0; chain < 3 * CHAINS; chain++) {
            RandomLineages lineages =
                    new RandomLineages(new InitialNetworks(5, layout), everything(0.1, 0.1, 0.3), 8, 4000 + chain);
            Map<Long, String> structures = new HashMap<>();
            lineages.reproduce(REPRODUCTIONS, child -> {
                requireInvariants(child.genotype(), 5, layout);
                requireOneMeaning(child.genotype(), structures);
            });
        }
    }

    @Test
    void modulesAreAdded_upToTheLimit() {
        ModuleLayout layout = ModuleLayout.withPreferenceNeurons(1, 1);
        VariationSettings settings = new VariationSettings(
                MutationRates.PUBLISHED.withModuleDuplication(0.5),
                new ModuleGate(MOST_MODULES, 10),
                0,
                false,
                InputSelection.ALL,
                ActivationFunction.TANH);
        RandomLineages lineages = new RandomLineages(new InitialNetworks(5, layout), settings, 8, 5000);
        int[] most = {0};
        lineages.reproduce(
                20 * REPRODUCTIONS,
                child -> most[0] = Math.max(most[0], child.genotype().modules()));
        assertThat(most[0]).isEqualTo(MOST_MODULES);
    }

    /** An assertion of equality that is fast enough for every gene of every offspring. */
    private static <T> void requireEqual(T actual, T expected, String what) {
        if (!actual.equals(expected)) {
            throw new AssertionError(what + ": expected " + expected + " but was " + actual);
        }
    }

    /** Checks what the constructor does not check. The constructor checks node order, link ends and duplicates. */
    private static void requireInvariants(Genotype genotype, int inputs, ModuleLayout start) {
        assertThat(genotype.inputs()).isEqualTo(inputs);
        for (int i = 0; i < inputs; i++) {
            requireEqual(genotype.nodes().get(i).innovation(), -i - 1L, "input innovation");
        }
        ModuleLayout layout = genotype.layout();
        assertThat(layout.policyNeuronsPerModule()).isEqualTo(start.policyNeuronsPerModule());
        assertThat(layout.standardMultitask()).isEqualTo(start.standardMultitask());
        for (NodeGene node : genotype.nodes()) {
            requireEqual(node.fromCombiningCrossover(), false, "shadow in a network");
        }
        assertThat(genotype.links().stream().filter(link -> !link.active()).count())
                .isLessThanOrEqualTo(1);
    }

    private static void requireModules(Offspring child, ModuleLayout start, boolean canGrow) {
        assertThat(child.genotype().layout().hasPreferenceNeurons()).isEqualTo(start.hasPreferenceNeurons());
        if (!canGrow) {
            assertThat(child.genotype().layout()).isEqualTo(start);
            assertThat(child.mutations()).doesNotContain("MMD");
        }
    }

    private static void requireOutputsKnownByPosition(Genotype genotype) {
        for (int output = 0; output < genotype.outputs(); output++) {
            long innovation =
                    genotype.nodes().get(genotype.firstOutput() + output).innovation();
            requireEqual(innovation, -(genotype.inputs() + output) - 1L, "output innovation");
        }
    }

    private static void requirePartOf(Genotype genotype, Archetype archetype) {
        int position = 0;
        List<NodeGene> entries = archetype.entries();
        for (NodeGene node : genotype.nodes()) {
            while (position < entries.size() && entries.get(position).innovation() != node.innovation()) {
                position++;
            }
            requireEqual(position < entries.size(), true, "place in the archetype");
            position++;
        }
    }

    /** Checks that a link innovation always has the same end points, in all generations. */
    private static void requireOneMeaning(Genotype genotype, Map<Long, String> structures) {
        for (LinkGene link : genotype.links()) {
            String ends = link.source() + ">" + link.target();
            requireEqual(structures.merge(link.innovation(), ends, (first, next) -> first), ends, "ends of a link");
        }
    }

    private static void requireShadowsInArchetype(Archetype archetype) {
        Set<Long> shadows = new HashSet<>();
        Set<Long> neurons = new HashSet<>();
        for (NodeGene entry : archetype.entries()) {
            assertThat((entry.fromCombiningCrossover() ? shadows : neurons).add(entry.innovation()))
                    .isTrue();
        }
        assertThat(shadows).containsAll(archetype.shadows().values());
        assertThat(neurons).containsAll(archetype.shadows().keySet());
    }

    private static void requireRoundTrip(Genotype genotype) {
        try {
            assertThat(GenotypeJson.read(GenotypeJson.write(genotype))).isEqualTo(genotype);
            if (genotype.id() % 10 == 0) {
                assertThat(GenotypeXml.read(GenotypeXml.write(genotype))).isEqualTo(genotype);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
