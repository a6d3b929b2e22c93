package mmneat.analysis.results;

import com.fasterxml.jackson.databind.MappingIterator;
import com.fasterxml.jackson.databind.ObjectReader;
import com.fasterxml.jackson.dataformat.csv.CsvMapper;
import com.fasterxml.jackson.dataformat.csv.CsvSchema;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * The paper's champions and learning curves, read off its figures: 30 champions per method, medians for generations 0
 * to 200.
 *
 * <p>Source and precision: {@code SOURCE.md} beside the data. Methods have the paper's names, see {@link
 * MethodName#paper}.
 */
public final class PublishedResults {

    /** Reference to the paper, for captions. */
    public static final String SOURCE = "Schrum and Miikkulainen 2016";

    /**
     * A champion of the paper.
     *
     * @param version blended, interleaved or isolated
     * @param method the paper's name
     * @param averageScore mean score of 1,000 games
     * @param mostUsedModulePercent share of time steps in which it used its most-used module, in percent
     */
    public record Champion(String version, String method, double averageScore, double mostUsedModulePercent) {}

    private record CurvePoint(String version, String method, int generation, double medianScore) {}

    private final List<Champion> champions;
    private final List<CurvePoint> curves;

    private PublishedResults(List<Champion> champions, List<CurvePoint> curves) {
        this.champions = champions;
        this.curves = curves;
    }

    /** Reads the published results from the resources. */
    public static PublishedResults read() {
        List<Champion> champions = rows("champions.csv").stream()
                .map(row -> new Champion(
                        Objects.requireNonNull(row.get("version")),
                        Objects.requireNonNull(row.get("method")),
                        Double.parseDouble(row.get("average_score")),
                        Double.parseDouble(row.get("most_used_module_percent"))))
                .toList();
        List<CurvePoint> curves = rows("learning-curves.csv").stream()
                .map(row -> new CurvePoint(
                        Objects.requireNonNull(row.get("version")),
                        Objects.requireNonNull(row.get("method")),
                        Integer.parseInt(row.get("generation")),
                        Double.parseDouble(row.get("median_champion_score"))))
                .toList();
        return new PublishedResults(champions, curves);
    }

    /** The champions of a method; none if it was not published. Both names of a method are understood. */
    public List<Champion> champions(String version, String method) {
        String name = MethodName.paper(method);
        return champions.stream()
                .filter(c -> c.version().equals(version) && c.method().equals(name))
                .toList();
    }

    /** Median champion score of generations 0, 1, ...; empty if it was not published. */
    public double[] medianCurve(String version, String method) {
        String name = MethodName.paper(method);
        return curves.stream()
                .filter(point ->
                        point.version().equals(version) && point.method().equals(name))
                .mapToDouble(CurvePoint::medianScore)
                .toArray();
    }

    private static List<Map<String, String>> rows(String file) {
        ObjectReader reader = new CsvMapper()
                .readerForMapOf(String.class)
                .with(CsvSchema.emptySchema().withHeader());
        try (InputStream in = PublishedResults.class.getResourceAsStream("/mmneat/analysis/paper/" + file);
                MappingIterator<Map<String, String>> rows = reader.readValues(in)) {
            return rows.readAll();
        } catch (IOException e) {
            throw new UncheckedIOException("the packed file " + file + " cannot be read", e);
        }
    }
}
