package mmneat.nsga2;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import mmneat.GoldenData;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Selection equals the original's in every case of golden/nsga2. */
@Tag("conformance")
class Nsga2ConformanceTest {

    @ParameterizedTest
    @ValueSource(strings = {"sorting_2obj.json", "sorting_3obj.json", "sorting_large.json"})
    void sorting_givesTheOriginalsFrontsAndDistances(String file) throws IOException {
        for (JsonNode golden : cases(file)) {
            double[][] scores = matrix(golden.get("scores"));
            NondominatedSorting sorting = NondominatedSorting.of(scores, Crowding.WHOLE_POPULATION);
            String name = golden.get("name").asText();
            assertThat(individuals(scores.length, sorting::rank))
                    .as("%s: ranks", name)
                    .isEqualTo(integers(golden.get("rank")));
            assertThat(IntStream.range(0, scores.length)
                            .mapToDouble(sorting::crowding)
                            .toArray())
                    .as("%s: crowding", name)
                    .isEqualTo(doubles(golden.get("crowding")));
            assertThat(individuals(scores.length, sorting::individualAt))
                    .as("%s: order", name)
                    .isEqualTo(integers(golden.get("sorted_order")));
            assertThat(sorting.fronts())
                    .as("%s: fronts", name)
                    .containsExactlyElementsOf(
                            IntStream.range(0, golden.get("fronts").size())
                                    .mapToObj(i -> integers(golden.get("fronts").get(i)))
                                    .toList());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"sorting_2obj.json", "sorting_3obj.json", "sorting_large.json"})
    void survivors_equalTheOriginals_inItsOrder(String file) throws IOException {
        for (JsonNode golden : cases(file)) {
            double[][] scores = matrix(golden.get("scores"));
            for (JsonNode selection : golden.get("selection")) {
                int keep = selection.get("keep").asInt();
                assertThat(SurvivorSelection.survivors(scores, keep, Crowding.WHOLE_POPULATION))
                        .as("%s: keep %d", golden.get("name").asText(), keep)
                        .isEqualTo(integers(selection.get("survivors")));
            }
        }
    }

    @Test
    void children_comeFromTheOriginalsParents_withItsDraws() throws IOException {
        for (JsonNode golden : cases("mating.json")) {
            double[][] scores = matrix(golden.get("scores"));
            ResumableRandom random = new ResumableRandom(golden.get("seed").asLong());
            ParentSelection selection = new ParentSelection(
                    golden.get("mating").asBoolean(),
                    golden.get("crossover_rate").asDouble(),
                    Crowding.WHOLE_POPULATION);
            List<int[]> origins = selection.children(
                    IntStream.range(0, scores.length).boxed().toList(),
                    scores,
                    golden.get("generation").asInt() == 0,
                    golden.get("num_children").asInt(),
                    new VariationWithoutDraws(),
                    random);
            String name = golden.get("name").asText();
            assertThat(origins)
                    .as(name)
                    .containsExactlyElementsOf(Arrays.asList(IntStream.range(
                                    0, golden.get("children").size())
                            .mapToObj(i -> integers(golden.get("children").get(i)))
                            .toArray(int[][]::new)));
            assertThat(random.nextLong())
                    .as("%s: draws", name)
                    .isEqualTo(golden.get("next_long_after").asLong());
        }
    }

    @Test
    void hypervolume_equalsTheOriginals() throws IOException {
        for (JsonNode golden : cases("hypervolume.json")) {
            double[][] scores = matrix(golden.get("scores"));
            double expected = golden.get("hypervolume").asDouble();
            assertThat(Hypervolume.of(scores, doubles(golden.get("mins"))))
                    .isCloseTo(expected, within(1e-9 * expected));
            assertThat(Hypervolume.frontSize(scores))
                    .isEqualTo(golden.get("front_size").asInt());
        }
    }

    private static JsonNode cases(String file) throws IOException {
        JsonNode cases = new ObjectMapper()
                .readTree(GoldenData.folder("nsga2").resolve(file).toFile());
        assertThat(cases).as(file).isNotEmpty();
        return cases;
    }

    private static int[] individuals(int size, java.util.function.IntUnaryOperator value) {
        return IntStream.range(0, size).map(value).toArray();
    }

    private static double[][] matrix(JsonNode rows) {
        return IntStream.range(0, rows.size())
                .mapToObj(i -> doubles(rows.get(i)))
                .toArray(double[][]::new);
    }

    private static double[] doubles(JsonNode values) {
        return IntStream.range(0, values.size())
                .mapToDouble(i -> Double.parseDouble(values.get(i).asText()))
                .toArray();
    }

    private static int[] integers(JsonNode values) {
        return IntStream.range(0, values.size()).map(i -> values.get(i).asInt()).toArray();
    }

    /** Children are rows of the golden file: base parent, other parent or -1, whether crossover returned the child. */
    private record VariationWithoutDraws() implements Variation<Integer, int[]> {
        @Override
        public int[] fromOne(Integer parent, ResumableRandom random) {
            return new int[] {parent, -1, 0};
        }

        @Override
        public List<int[]> fromTwo(Integer parent, Integer mate, int room, ResumableRandom random) {
            int[] withMateStructure = {mate, parent, 1};
            int[] withParentStructure = {parent, mate, 0};
            return room > 1 ? List.of(withMateStructure, withParentStructure) : List.of(withParentStructure);
        }
    }
}
