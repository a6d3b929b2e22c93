package mmneat.analysis.statistics;

import com.fasterxml.jackson.databind.SequenceWriter;
import com.fasterxml.jackson.dataformat.csv.CsvMapper;
import com.fasterxml.jackson.dataformat.csv.CsvSchema;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.stream.Collectors;

/** A comparison as CSV in full precision: one row per test. */
public final class ComparisonCsv {

    private static final List<String> COLUMNS =
            List.of("test", "first", "second", "statistic", "p", "corrected_p", "method", "a", "rank_biserial");

    private ComparisonCsv() {}

    /** The tests of comparisons, one after the other. */
    public static String of(List<ComparisonReport> reports) {
        StringWriter text = new StringWriter();
        CsvSchema schema = CsvSchema.builder()
                .addColumns(COLUMNS, CsvSchema.ColumnType.NUMBER_OR_STRING)
                .setUseHeader(true)
                .build();
        try (SequenceWriter rows = new CsvMapper().writer(schema).writeValues(text)) {
            for (ComparisonReport report : reports) {
                write(report, rows);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return text.toString();
    }

    private static void write(ComparisonReport report, SequenceWriter rows) throws IOException {
        if (report.comparison().isPresent()) {
            KruskalWallis test = report.comparison().get().kruskalWallis();
            String groups = report.samples().stream().map(Sample::label).collect(Collectors.joining("; "));
            rows.write(List.of(
                    "Kruskal-Wallis",
                    groups,
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
