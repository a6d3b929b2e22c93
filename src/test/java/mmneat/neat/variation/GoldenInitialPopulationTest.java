package mmneat.neat.variation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.stream.Stream;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

/** Each of the sixteen configurations starts with the original's initial networks. */
@Tag("conformance")
class GoldenInitialPopulationTest {

    @TestFactory
    Stream<DynamicTest> initialPopulation_isTheOriginals() {
        var cases = GoldenGenotypes.elements(
                GoldenGenotypes.file("initial_populations").required("cases"));
        assertThat(cases).hasSize(16);
        return cases.stream().map(c -> dynamicTest(c.required("configuration").textValue(), () -> check(c)));
    }

    private static void check(JsonNode c) {
        Genotype expectedExample = GoldenGenotypes.genotype(c.required("example_genotype"));
        InitialNetworks networks = new InitialNetworks(
                c.required("num_in").intValue(),
                layoutOf(c.required("configuration").textValue()));
        ResumableRandom random = new ResumableRandom(c.required("seed").longValue());

        Genotype example = networks.create(-1, random);
        GenePool pool = GenePool.foundedOn(example);
        List<Genotype> population = networks.createPopulation(2, pool, random);

        // The original's example has unused usage counts of another length.
        assertThat(example.withModuleUsage(expectedExample.moduleUsage())).isEqualTo(expectedExample);
        assertThat(population)
                .isEqualTo(GoldenGenotypes.elements(c.required("population")).stream()
                        .map(GoldenGenotypes::genotype)
                        .toList());
        assertThat(pool.state()).isEqualTo(GoldenGenotypes.state(c.required("state")));
        assertThat(example.layout().hasPreferenceNeurons())
                .isEqualTo(c.required("uses_preference_neurons").booleanValue());
        // The original seeds its generator again before evolution starts.
        random.setSeed(c.required("seed").longValue());
        assertThat(random.nextInt()).isEqualTo(c.required("next_int_after").intValue());
    }

    private static ModuleLayout layoutOf(String configuration) {
        String method = configuration.substring(configuration.indexOf('-') + 1);
        return switch (method) {
            case "OneModule" -> ModuleLayout.single(1);
            case "TwoModules" -> ModuleLayout.withPreferenceNeurons(2, 1);
            case "ThreeModules" -> ModuleLayout.withPreferenceNeurons(3, 1);
            case "MMD" -> ModuleLayout.withPreferenceNeurons(1, 1);
            case "Multitask", "TwoModuleMultitask" -> ModuleLayout.multitask(2, 1);
            case "ThreeModuleMultitask" -> ModuleLayout.multitask(3, 1);
            default -> throw new IllegalArgumentException(configuration);
        };
    }
}
