package mmneat.analysis.statistics;

import com.fasterxml.jackson.databind.SequenceWriter;
import com.fasterxml.jackson.dataformat.csv.CsvMapper;
import com.fasterxml.jackson.dataformat.csv.CsvSchema;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.List;

/** A comparison as CSV in full precision: one row per test. */
public final class ComparisonCsv {

    private static final List<String> COLUMNS =
            List.of("test", "first", "second", "statistic", "p", "corrected_p", "method", "a", "rank_biserial");

    private ComparisonCsv() {}

    public static String of(ComparisonReport report) {
        StringWriter text = new StringWriter();
        CsvSchema schema = CsvSchema.builder()
                .addColumns(COLUMNS, CsvSchema.ColumnType.NUMBER_OR_STRING)
                .setUseHeader(true)
                .build();
        try (SequenceWriter rows = new CsvMapper().writer(schema).writeValues(text)) {
            if (report.comparison().isPresent()) {
                KruskalWallis test = report.comparison().get().kruskalWallis();
                rows.write(List.of(
                        "Kruskal-Wallis",
                        "all",
                        "",
                        test.h(),
                        test.p(),
                        test.p(),
                        "df=" + test.degreesOfFreedom(),
                        "",
                        ""));
                for (Comparison.Pair pair : report.comparison().get().pairs()) {
                    rows.write(row("Mann-Whitney", pair, pair.test().b()));
                }
            }
            for (Comparison.Pair pair : report.pairsAgainstPaper()) {
                rows.write(row("against the paper", pair, pair.test().b() + " (paper)"));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return text.toString();
    }

    private static List<Object> row(String name, Comparison.Pair pair, String second) {
        PairwiseTest test = pair.test();
        return List.of(
                name,
                test.a(),
                second,
                test.u(),
                test.p(),
                pair.corrected(),
                test.method() == PairwiseTest.Method.EXACT ? "exact" : "normal",
                test.effectSize(),
                test.rankBiserial());
    }
}
