package mmneat.analysis.statistics;

import java.util.ArrayList;
import java.util.List;

/**
 * The paper's comparison of several methods (its Tables 3 to 5): Kruskal-Wallis over all, Mann-Whitney for every pair
 * with Bonferroni's correction, as R's {@code kruskal.test} and {@code pairwise.wilcox.test}.
 *
 * @param samples the groups, in the order of the tables
 * @param kruskalWallis over all groups
 * @param pairs every pair of groups, first group first
 */
public record Comparison(List<Sample> samples, KruskalWallis kruskalWallis, List<Pair> pairs) {

    /**
     * One pair of methods.
     *
     * @param test the test of the two
     * @param corrected p times the number of defined tests, cut at 1; NaN if p is
     */
    public record Pair(PairwiseTest test, double corrected) {}

    /** A difference is called significant below this corrected p, as in the paper. */
    public static final double SIGNIFICANCE = 0.05;

    public Comparison {
        samples = List.copyOf(samples);
        pairs = List.copyOf(pairs);
    }

    public static Comparison of(List<Sample> samples) {
        List<PairwiseTest> tests = new ArrayList<>();
        for (int a = 0; a < samples.size(); a++) {
            for (int b = a + 1; b < samples.size(); b++) {
                tests.add(PairwiseTest.of(samples.get(a), samples.get(b)));
            }
        }
        return new Comparison(samples, KruskalWallis.of(samples), bonferroni(tests));
    }

    /** Corrects a family of tests; undefined ones (p is NaN) do not count. */
    public static List<Pair> bonferroni(List<PairwiseTest> tests) {
        long defined = tests.stream().filter(test -> !Double.isNaN(test.p())).count();
        // Math.min keeps NaN.
        return tests.stream()
                .map(test -> new Pair(test, Math.min(1, test.p() * defined)))
                .toList();
    }

    /** Number of defined pairwise tests: the factor of the correction. */
    public int comparisons() {
        return (int)
                pairs.stream().filter(pair -> !Double.isNaN(pair.test().p())).count();
    }
}
