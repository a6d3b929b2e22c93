package mmneat.analysis.results;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import mmneat.analysis.statistics.Comparison;
import mmneat.analysis.statistics.Sample;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PublishedResultsTest {

    private final PublishedResults paper = PublishedResults.read();

    private Sample champions(String version, String method) {
        return new Sample(
                method,
                paper.champions(version, method).stream()
                        .mapToDouble(PublishedResults.Champion::averageScore)
                        .toArray());
    }

    /** The paper's H, within what the rounding of the drawings can change. */
    @ParameterizedTest
    @CsvSource({"blended,49.694,0.2", "interleaved,37.0228,0.2", "isolated,12.5529,0.14"})
    void championsOfAVersion_giveThePapersKruskalWallis(String version, double h, double tolerance) {
        List<Sample> samples = Stream.of("1M", "MT", "MT2", "MT3", "MMD", "3M", "2M")
                .filter(method -> !paper.champions(version, method).isEmpty())
                .map(method -> champions(version, method))
                .toList();
        assertThat(Comparison.of(samples).kruskalWallis().h()).isCloseTo(h, within(tolerance));
    }

    @Test
    void champions_areThirtyPerMethod_withTheReadMesMedians() {
        assertThat(champions("blended", "2M").size()).isEqualTo(30);
        assertThat(champions("blended", "2M").median()).isCloseTo(16816, within(1.0));
        assertThat(champions("isolated", "MMD").median()).isCloseTo(42315, within(1.0));
        assertThat(champions("isolated", "MM(D)"))
                .isEqualTo(new Sample("MM(D)", champions("isolated", "MMD").values()));
        assertThat(paper.champions("blended", "MT")).isEmpty();
    }

    @Test
    void medianCurve_hasGenerationsZeroToTwoHundred() {
        double[] curve = paper.medianCurve("blended", "1M");
        assertThat(curve).hasSize(201);
        assertThat(curve[0]).isEqualTo(1391.8);
        assertThat(paper.medianCurve("blended", "5M")).isEmpty();
    }
}
