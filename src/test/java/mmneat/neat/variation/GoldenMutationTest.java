package mmneat.neat.variation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.stream.Stream;
import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.GenotypeDraft;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

/**
 * Every recorded mutation of the original is reproduced: the same genes, archetype and counters with the same random
 * draws.
 */
@Tag("conformance")
class GoldenMutationTest {

    @TestFactory
    Stream<DynamicTest> operator_changesTheSameGenes_asTheOriginal() {
        return cases("mutation_operators", 48);
    }

    @TestFactory
    Stream<DynamicTest> mutation_changesTheSameGenes_asTheOriginal() {
        return cases("mutation_full", 57);
    }

    private static Stream<DynamicTest> cases(String file, int count) {
        var cases = GoldenGenotypes.elements(GoldenGenotypes.file(file).required("cases"));
        assertThat(cases).hasSize(count);
        return cases.stream().map(c -> dynamicTest(c.required("name").textValue(), () -> check(c)));
    }

    private static void check(JsonNode c) {
        Genotype before = GoldenGenotypes.genotype(c.required("before"));
        GenePool pool = GenePool.resume(GoldenGenotypes.state(c.required("state_before")));
        ResumableRandom random = new ResumableRandom(c.required("seed").longValue());

        Genotype after = perform(c, before, pool, random);

        Genotype expected = GoldenGenotypes.genotype(c.required("after"));
        assertThat(after.nodes()).isEqualTo(expected.nodes());
        assertThat(after.links()).isEqualTo(expected.links());
        assertThat(after).isEqualTo(expected);
        assertThat(pool.state()).isEqualTo(GoldenGenotypes.state(c.required("state_after")));
        assertThat(random.nextInt()).isEqualTo(c.required("next_int_after").intValue());
    }

    private static Genotype perform(JsonNode c, Genotype before, GenePool pool, ResumableRandom random) {
        String operation = c.required("operation").textValue();
        if (operation.equals("copy")) {
            return GenotypeDraft.copyOf(before, pool.takeGenotypeId()).finish();
        }
        GenotypeDraft draft = GenotypeDraft.of(before);
        if (operation.equals("mutate")) {
            MutationRates rates = GoldenGenotypes.rates(c.required("parameters"));
            new OffspringMutation(new VariationSettings(rates)).apply(draft, pool, random);
        } else {
            assertThat(operator(operation, c).apply(draft, pool, random)).isTrue();
        }
        return draft.finish();
    }

    private static MutationOperator operator(String name, JsonNode c) {
        ActivationFunction tanh = ActivationFunction.TANH;
        return switch (name) {
            case "link" -> new NewLinkMutation();
            case "splice" -> new SpliceNeuronMutation(tanh);
            case "all_weights" -> new AllWeightMutation(c.required("rate").doubleValue());
            case "one_weight" -> new OneWeightMutation();
            case "mmd" -> new ModuleDuplication(tanh);
            case "mmp" -> new PreviousModuleMutation(tanh);
            case "mmr" -> new RandomModuleMutation(InputSelection.ALL, tanh);
            case "mm_full" -> new FullModuleMutation(tanh);
            case "delete_link" -> new DeleteLinkMutation();
            default -> throw new IllegalArgumentException(name);
        };
    }
}
