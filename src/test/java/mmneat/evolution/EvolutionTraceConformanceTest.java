package mmneat.evolution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.neat.network.Network;
import mmneat.neat.network.NetworkState;
import mmneat.neat.variation.GoldenGenotypes;
import mmneat.neat.variation.InitialNetworks;
import mmneat.neat.variation.Offspring;
import mmneat.neat.variation.Reproduction;
import mmneat.neat.variation.VariationSettings;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Complete small evolutions equal the original's, gene by gene and draw by draw, from the first network to the last
 * child. Parents and survivors are those of the golden file: {@code golden/networks/trace_*.json}.
 */
@Tag("conformance")
class EvolutionTraceConformanceTest {

    @ParameterizedTest
    @ValueSource(strings = {"OneModule", "TwoModules", "Multitask2", "MMD"})
    void smallEvolution_equalsTheOriginals(String variant) {
        JsonNode trace = GoldenGenotypes.file("trace_" + variant);
        Genotype expectedExample = GoldenGenotypes.genotype(trace.get("example_genotype"));
        InitialNetworks networks = new InitialNetworks(trace.get("num_in").intValue(), expectedExample.layout());
        int seed = trace.get("seed").intValue();
        ResumableRandom random = new ResumableRandom(seed);

        Genotype example = networks.create(-1, random);
        // The original's example network has one unused usage count per module of the task.
        assertThat(example).isEqualTo(expectedExample.withModuleUsage(example.moduleUsage()));
        GenePool pool = GenePool.foundedOn(example);
        assertThat(pool.state()).isEqualTo(GoldenGenotypes.state(trace.get("state_after_archetype")));
        List<Genotype> population =
                networks.createPopulation(trace.get("population_size").intValue(), pool, random);
        assertThat(population).isEqualTo(genotypes(trace.get("initial_population")));

        random.setSeed(seed);
        Reproduction reproduction =
                new Reproduction(new VariationSettings(GoldenGenotypes.rates(trace.get("parameters"))), pool);
        int cleanFrequency = (int) GoldenGenotypes.parameter(trace.get("parameters"), "cleanFrequency", 10);
        for (JsonNode generation : trace.get("generations")) {
            population = evaluated(population, generation.get("evaluate"), random);
            List<Genotype> children = children(population, generation.get("reproduce"), reproduction, random);
            assertThat(children).isEqualTo(genotypes(generation.get("children")));
            population = survivors(population, children, generation.get("next_population_ids"));
            if (generation.get("generation").intValue() % cleanFrequency == 0) {
                pool.archetype().clean(population);
            }
            assertThat(pool.state()).isEqualTo(GoldenGenotypes.state(generation.get("state_after_cleaning")));
        }
        assertThat(random.nextInt()).isEqualTo(trace.get("next_int_after").intValue());
    }

    private static List<Genotype> evaluated(List<Genotype> population, JsonNode evaluations, ResumableRandom random) {
        List<Genotype> evaluated = new ArrayList<>(population);
        for (JsonNode evaluation : evaluations) {
            int member = evaluation.get("member").intValue();
            Genotype genotype = population.get(member);
            ModuleLayout layout = genotype.layout();
            NetworkState state = Network.compile(genotype).newState();
            for (JsonNode step : evaluation.get("steps")) {
                if (step.has("preset_module")) {
                    state.presetModule(step.get("preset_module").intValue());
                }
                int module = state.activate(doubles(step.get("inputs")), random);
                assertThat(module).isEqualTo(step.get("chosen_module").intValue());
                double[] returned = doubles(step.get("returned"));
                for (int neuron = 0; neuron < layout.policyNeuronsPerModule(); neuron++) {
                    assertThat(state.policyOutput(neuron)).isCloseTo(returned[neuron], within(1e-15));
                }
            }
            int[] usage = state.moduleUsage();
            assertThat(usage).isEqualTo(integers(evaluation.get("module_usage")));
            evaluated.set(member, genotype.withModuleUsage(usage));
        }
        return evaluated;
    }

    private static List<Genotype> children(
            List<Genotype> parents, JsonNode passes, Reproduction reproduction, ResumableRandom random) {
        List<Genotype> children = new ArrayList<>();
        for (JsonNode pass : passes) {
            Genotype parent = parents.get(pass.get("parent_a").intValue());
            if (pass.has("parent_b")) {
                Genotype mate = parents.get(pass.get("parent_b").intValue());
                reproduction.fromTwo(parent, mate, 2, random).stream()
                        .map(Offspring::genotype)
                        .forEach(children::add);
            } else {
                children.add(reproduction.fromOne(parent, random).genotype());
            }
        }
        return children;
    }

    private static List<Genotype> survivors(List<Genotype> parents, List<Genotype> children, JsonNode ids) {
        Map<Long, Genotype> byId = new LinkedHashMap<>();
        parents.forEach(genotype -> byId.put(genotype.id(), genotype));
        children.forEach(genotype -> byId.put(genotype.id(), genotype));
        List<Genotype> survivors = new ArrayList<>();
        ids.forEach(id -> survivors.add(byId.get(id.longValue())));
        return survivors;
    }

    private static List<Genotype> genotypes(JsonNode records) {
        return GoldenGenotypes.elements(records).stream()
                .map(GoldenGenotypes::genotype)
                .toList();
    }

    private static double[] doubles(JsonNode values) {
        return GoldenGenotypes.elements(values).stream()
                .mapToDouble(JsonNode::doubleValue)
                .toArray();
    }

    private static int[] integers(JsonNode values) {
        return GoldenGenotypes.elements(values).stream()
                .mapToInt(JsonNode::intValue)
                .toArray();
    }
}
