package mmneat.analysis.statistics;

import java.util.List;
import java.util.stream.Collectors;

/** A comparison as CSV in full precision: one row per test. */
public final class ComparisonCsv {

    private ComparisonCsv() {}

    /** The tests of comparisons, one after the other. */
    public static String of(List<ComparisonReport> reports) {
        CsvText csv =
                new CsvText("test", "first", "second", "statistic", "p", "corrected_p", "method", "a", "rank_biserial");
        reports.forEach(report -> write(report, csv));
        return csv.text();
    }

    private static void write(ComparisonReport report, CsvText csv) {
        if (report.comparison().isPresent()) {
            KruskalWallis test = report.comparison().get().kruskalWallis();
            String groups = report.samples().stream().map(Sample::label).collect(Collectors.joining("; "));
            csv.row(
                    "Kruskal-Wallis",
                    groups,
                    "",
                    test.h(),
                    test.p(),
                    test.p(),
                    "df=" + test.degreesOfFreedom(),
                    "",
                    "");
            for (Comparison.Pair pair : report.comparison().get().pairs()) {
                csv.row(row("Mann-Whitney", pair, pair.test().b()));
            }
        }
        for (Comparison.Pair pair : report.pairsAgainstPaper()) {
            csv.row(row("against the paper", pair, pair.test().b() + " (paper)"));
        }
    }

    private static Object[] row(String name, Comparison.Pair pair, String second) {
        PairwiseTest test = pair.test();
        return new Object[] {
            name,
            test.a(),
            second,
            test.u(),
            test.p(),
            pair.corrected(),
            test.method() == PairwiseTest.Method.EXACT ? "exact" : "normal",
            test.effectSize(),
            test.rankBiserial()
        };
    }
}
