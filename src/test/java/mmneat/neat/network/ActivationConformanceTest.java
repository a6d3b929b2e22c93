package mmneat.neat.network;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import mmneat.GoldenData;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

/** Activation sequences that the original produced, equal to the last bit. */
@Tag("conformance")
class ActivationConformanceTest {

    private static final JsonMapper JSON = JsonMapper.builder().build();

    @TestFactory
    Stream<DynamicTest> recordedNetworks() throws IOException {
        List<DynamicTest> tests = new ArrayList<>();
        try (Stream<Path> files = Files.list(GoldenData.folder("networks"))) {
            List<Path> recorded = files.filter(
                            file -> file.getFileName().toString().matches("activation_.*\\.json"))
                    .sorted()
                    .toList();
            for (Path file : recorded) {
                JSON.readTree(file.toFile()).get("cases").forEach(example -> tests.add(test(example)));
            }
        }
        assertThat(tests).hasSize(57);
        return tests.stream();
    }

    @TestFactory
    Stream<DynamicTest> savedGenotypes() throws IOException {
        Path folder = GoldenData.folder("networks");
        List<DynamicTest> tests = new ArrayList<>();
        for (String name : List.of("small_genotype.json", "run_member_two_modules.json")) {
            tests.add(test(JSON.readTree(folder.resolve(name).toFile()).get("activation")));
        }
        return tests.stream();
    }

    private static DynamicTest test(JsonNode example) {
        return DynamicTest.dynamicTest(example.get("name").asText(), () -> {
            Genotype genotype = genotype(example.get("genotype"));
            replay(example, genotype, Network.compile(genotype).newState());
            replay(example, genotype, Network.compileWithAllNodes(genotype).newState());
        });
    }

    private static void replay(JsonNode example, Genotype genotype, NetworkState state) {
        ResumableRandom random = new ResumableRandom(1);
        int[] expectedUsage = integers(example.get("final_module_usage"));
        assertThat(example.get("steps")).isNotEmpty();
        for (JsonNode step : example.get("steps")) {
            if (step.get("flush_before").asBoolean()) {
                state.flush();
            }
            if (step.has("preset_module")) {
                state.presetModule(step.get("preset_module").asInt());
            }
            int chosen = state.activate(doubles(step.get("inputs")), random);
            int recorded = step.get("chosen_module").asInt();
            if (step.has("tied_modules")) {
                assertThat(integers(step.get("tied_modules"))).contains(chosen);
                expectedUsage[recorded]--;
                expectedUsage[chosen]++;
            } else {
                assertThat(chosen).isEqualTo(recorded);
            }
            compareActivations(step, genotype, state);
        }
        assertThat(state.moduleUsage()).isEqualTo(expectedUsage);
    }

    private static void compareActivations(JsonNode step, Genotype genotype, NetworkState state) {
        double[] outputs = doubles(step.get("all_outputs"));
        assertThat(outputs).hasSize(genotype.outputs());
        for (int i = 0; i < outputs.length; i++) {
            assertThat(state.outputActivation(i)).isEqualTo(outputs[i]);
        }
        double[] returned = doubles(step.get("returned"));
        for (int i = 0; i < returned.length; i++) {
            double actual = step.has("tied_modules")
                    ? state.moduleOutput(step.get("chosen_module").asInt(), i)
                    : state.policyOutput(i);
            assertThat(actual).isEqualTo(returned[i]);
        }
        double[] preferences = doubles(step.get("preferences"));
        for (int i = 0;
                genotype.layout().hasPreferenceNeurons() && genotype.modules() > 1 && i < preferences.length;
                i++) {
            assertThat(state.preference(i)).isEqualTo(preferences[i]);
        }
        if (step.has("all_activations")) {
            double[] activations = doubles(step.get("all_activations"));
            assertThat(activations).hasSize(genotype.nodes().size());
            for (int i = 0; i < activations.length; i++) {
                if (state.network().hasNode(i)) {
                    assertThat(state.nodeActivation(i)).isEqualTo(activations[i]);
                }
            }
        }
    }

    static Genotype genotype(JsonNode json) {
        List<NodeGene> nodes = new ArrayList<>();
        for (JsonNode row : json.get("nodes")) {
            nodes.add(new NodeGene(
                    row.get(0).asLong(),
                    NodeType.ofCode(row.get(1).asInt()),
                    ActivationFunction.ofCode(row.get(2).asInt())));
        }
        List<LinkGene> links = new ArrayList<>();
        for (JsonNode row : json.get("links")) {
            links.add(new LinkGene(
                    row.get(0).asLong(),
                    row.get(1).asLong(),
                    row.get(2).asLong(),
                    row.get(3).asDouble(),
                    row.get(4).asInt() == 1,
                    row.get(5).asInt() == 1,
                    row.get(6).asInt() == 1));
        }
        ModuleLayout layout = new ModuleLayout(
                json.get("num_out").asInt(),
                json.get("num_modules").asInt(),
                json.get("policy_neurons_per_module").asInt(),
                json.get("standard_multitask").asBoolean());
        return new Genotype(
                json.get("id").asLong(), json.get("num_in").asInt(), layout, nodes, links, new int[layout.modules()]);
    }

    private static double[] doubles(JsonNode array) {
        double[] values = new double[array.size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = array.get(i).asDouble();
        }
        return values;
    }

    private static int[] integers(JsonNode array) {
        int[] values = new int[array.size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = array.get(i).asInt();
        }
        return values;
    }
}
