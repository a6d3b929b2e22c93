package mmneat.neat.variation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.stream.Stream;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.GenotypeDraft;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

/** Every recorded crossover of the original is reproduced: the same two children with the same random draws. */
@Tag("conformance")
class GoldenCrossoverTest {

    @TestFactory
    Stream<DynamicTest> crossover_givesTheSameChildren_asTheOriginal() {
        var cases = GoldenGenotypes.elements(GoldenGenotypes.file("crossover").required("cases"));
        assertThat(cases).hasSize(27);
        return cases.stream().map(c -> dynamicTest(c.required("name").textValue(), () -> check(c)));
    }

    private static void check(JsonNode c) {
        GenePool pool = GenePool.resume(GoldenGenotypes.state(c.required("state_before")));
        ResumableRandom random = new ResumableRandom(c.required("seed").longValue());
        GenotypeDraft a = GenotypeDraft.of(GoldenGenotypes.genotype(c.required("parent_a")));
        Genotype parentB = GoldenGenotypes.genotype(c.required("parent_b"));
        GenotypeDraft b = GenotypeDraft.of(parentB.withId(pool.takeGenotypeId()));

        new Crossover(c.required("crossExcessRate").doubleValue()).cross(a, b, pool.archetype(), random);

        Genotype childA = a.finish();
        Genotype expectedA = GoldenGenotypes.genotype(c.required("child_a"));
        assertThat(childA.links()).isEqualTo(expectedA.links());
        assertThat(childA).isEqualTo(expectedA);
        assertThat(b.finish()).isEqualTo(GoldenGenotypes.genotype(c.required("child_b")));
        assertThat(random.nextInt()).isEqualTo(c.required("next_int_after").intValue());
    }
}
