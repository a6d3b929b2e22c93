package mmneat.analysis.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.StreamSupport;
import mmneat.GoldenData;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Every number that R gave. */
@Tag("conformance")
class StatisticsConformanceTest {

    private static final double RELATIVE = 1e-9;

    @ParameterizedTest
    @ValueSource(strings = {"paper_shapes.json", "small_and_edge.json"})
    void comparison_ofGoldenGroups_isThatOfR(String file) throws IOException {
        for (JsonNode set : read(file)) {
            String name = set.get("name").asText();
            List<Sample> samples = new ArrayList<>();
            for (JsonNode group : set.get("groups")) {
                Sample sample = new Sample(group.get("label").asText(), doubles(group.get("values")));
                samples.add(sample);
                assertThat(sample.size()).isEqualTo(group.get("n").asInt());
                assertSame(name + " mean", sample.mean(), group.get("mean"));
                assertSame(name + " median", sample.median(), group.get("median"));
                assertSame(name + " sd", sample.standardDeviation(), group.get("sd"));
            }
            Comparison comparison = Comparison.of(samples);
            JsonNode expected = set.get("kruskal_wallis");
            KruskalWallis kruskalWallis = comparison.kruskalWallis();
            assertSame(name + " H", kruskalWallis.h(), expected.get("H"));
            assertThat(kruskalWallis.degreesOfFreedom())
                    .isEqualTo(expected.get("df").asInt());
            assertSame(name + " p", kruskalWallis.p(), expected.get("p"));
            assertSame(name + " tie correction", kruskalWallis.tieCorrection(), expected.get("tie_correction"));
            assertThat(comparison.comparisons())
                    .as(name)
                    .isEqualTo(set.get("comparisons").asInt());
            assertPairs(name, comparison, set.get("pairwise"));
        }
    }

    private static void assertPairs(String name, Comparison comparison, JsonNode expected) {
        assertThat(comparison.pairs()).as(name).hasSize(expected.size());
        for (JsonNode pair : expected) {
            String a = pair.get("a").asText();
            String b = pair.get("b").asText();
            Comparison.Pair ours = comparison.pairs().stream()
                    .filter(p -> p.test().a().equals(a) && p.test().b().equals(b))
                    .findFirst()
                    .orElseThrow();
            String where = name + " " + a + "-" + b;
            PairwiseTest test = ours.test();
            assertSame(where + " U", test.u(), pair.get("U_a"));
            assertThat(test.ties()).as(where).isEqualTo(pair.get("ties").asBoolean());
            assertThat(test.method().name().toLowerCase(java.util.Locale.ROOT))
                    .as(where)
                    .isEqualTo(pair.get("method").asText());
            assertSame(where + " p", test.p(), pair.get("p"));
            assertSame(where + " corrected p", ours.corrected(), pair.get("p_bonferroni"));
            double pairs = pair.get("n_a").asDouble() * pair.get("n_b").asDouble();
            assertThat(test.effectSize()).as(where).isEqualTo(pair.get("U_a").asDouble() / pairs, within(1e-12));
        }
    }

    @Test
    void exactTest_ofThirtyAgainstThirty_givesThePapersTables() throws IOException {
        for (JsonNode table : read("paper_tables.json")) {
            int comparisons = table.get("comparisons").asInt();
            int n = table.get("n_per_group").asInt();
            JsonNode kruskalWallis = table.get("kruskal_wallis");
            double p = KruskalWallis.chiSquareTail(
                    kruskalWallis.get("H").asDouble(), kruskalWallis.get("df").asInt());
            assertPrintsAs(p, kruskalWallis.get("p_published").asText());
            for (JsonNode pair : table.get("pairs")) {
                JsonNode candidates = pair.get("U_min_candidates");
                String published = pair.get("published").asText();
                if (pair.get("p_exact_times_m").isNull()) {
                    // Undetermined: every U of the range prints as the published 1.0, the next smaller one does not.
                    int smallest = candidates.get(0).asInt();
                    for (int u = smallest; u <= candidates.get(1).asInt(); u++) {
                        assertPrintsAs(corrected(n, u, comparisons), published);
                    }
                    assertThat(corrected(n, smallest - 1, comparisons)).isLessThan(0.95);
                    continue;
                }
                for (int i = 0; i < candidates.size(); i++) {
                    double ours = corrected(n, candidates.get(i).asInt(), comparisons);
                    assertSame(
                            pair.toString(), ours, pair.get("p_exact_times_m").get(i));
                    assertPrintsAs(ours, published);
                }
            }
        }
    }

    private static double corrected(int n, int u, int comparisons) {
        Sample[] samples = samplesWith(n, u);
        PairwiseTest test = PairwiseTest.of(samples[0], samples[1]);
        assertThat(test.u()).isEqualTo(u);
        assertThat(test.method()).isEqualTo(PairwiseTest.Method.EXACT);
        return Math.min(1, comparisons * test.p());
    }

    /** Two samples of n values without ties, the first of which wins in exactly u pairs. */
    private static Sample[] samplesWith(int n, int u) {
        double[] a = new double[n];
        double[] b = new double[n];
        int left = u;
        for (int i = 0; i < n; i++) {
            b[i] = 10 * (i + 1);
            int wins = Math.min(n, left);
            left -= wins;
            a[i] = 10 * wins + 5 + i / 100.0;
        }
        return new Sample[] {new Sample("a", a), new Sample("b", b)};
    }

    private static void assertPrintsAs(double value, String published) {
        BigDecimal printed = new BigDecimal(published);
        assertThat(BigDecimal.valueOf(value).setScale(printed.scale(), RoundingMode.HALF_UP))
                .isEqualByComparingTo(printed);
    }

    private static void assertSame(String what, double actual, JsonNode expected) {
        if (expected.isNull()) {
            assertThat(actual).as(what).isNaN();
        } else {
            assertThat(actual)
                    .as(what)
                    .isEqualTo(expected.asDouble(), within(RELATIVE * Math.max(1e-300, Math.abs(expected.asDouble()))));
        }
    }

    private static JsonNode read(String file) throws IOException {
        return new ObjectMapper()
                .readTree(GoldenData.folder("statistics").resolve(file).toFile());
    }

    private static double[] doubles(JsonNode array) {
        return StreamSupport.stream(array.spliterator(), false)
                .mapToDouble(JsonNode::asDouble)
                .toArray();
    }
}
