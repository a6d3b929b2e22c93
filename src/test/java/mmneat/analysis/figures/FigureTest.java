package mmneat.analysis.figures;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.ExperimentFinder;
import mmneat.analysis.results.PublishedResults;
import mmneat.analysis.results.RunFixture;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.xml.sax.EntityResolver;
import org.xml.sax.InputSource;

class FigureTest {

    @TempDir
    Path base;

    private final PublishedResults paper = PublishedResults.read();
    private List<Experiment> experiments;

    @BeforeEach
    void twoMethods() throws IOException {
        for (int run = 0; run < 3; run++) {
            RunFixture.evaluation(
                    RunFixture.run(base, "blended", "1M", run, 1000, 2000 + 100 * run, 3000 - 200 * run),
                    9000 + run,
                    10);
            RunFixture.evaluation(
                    RunFixture.run(base, "blended", "2M", run, 1500, 2500, 4000 + 300 * run), 15000 + run, 90, 10);
        }
        experiments = ExperimentFinder.find(List.of(base.resolve("blended")));
    }

    @Test
    void figures_areDrawnAsSvgAndPng_alwaysTheSame() throws Exception {
        for (Figure figure : List.of(
                LearningCurveFigure.overview("blended", experiments, paper),
                LearningCurveFigure.panels("blended", experiments, paper),
                ModuleUseFigure.of("blended", experiments, paper).orElseThrow())) {
            String svg = figure.svg();
            EntityResolver nothingIsFetched = (publicId, systemId) -> new InputSource(new StringReader(""));
            var parser = DocumentBuilderFactory.newInstance().newDocumentBuilder();
            parser.setEntityResolver(nothingIsFetched);
            assertThat(parser.parse(new InputSource(new StringReader(svg)))
                            .getDocumentElement()
                            .getTagName())
                    .isEqualTo("svg");
            assertThat(figure.svg()).isEqualTo(svg);
            // Text is written as text: it can be searched, and writing it needs no fonts.
            assertThat(svg).contains("</text>").contains("Champion");
            BufferedImage image =
                    ImageIO.read(new ByteArrayInputStream(figure.png().orElseThrow()));
            assertThat(image.getWidth()).isGreaterThan(1500);
            assertThat(figure.caption()).contains(PublishedResults.SOURCE);
        }
    }

    @Test
    void legend_showsEverySwatchAsTheFigureDrawsIt() {
        Figure medians = LearningCurveFigure.overview("blended", experiments, paper);
        assertThat(swatches(medians, "1M")).containsExactly("stroke=#1a1a1a width=2.2 dash=2 3");
        assertThat(swatches(medians, "the paper's"))
                .containsExactly("stroke=#a9aeb8 width=1.3 dash=2 3", "stroke=#a9aeb8 width=1.3 dash=");
        Figure curves = LearningCurveFigure.panels("blended", experiments, paper);
        assertThat(swatches(curves, "median over runs"))
                .endsWith("stroke=#1a1a1a width=2 dash=", "stroke=#0072b2 width=2 dash=");
        assertThat(swatches(curves, "the paper's median")).containsExactly("stroke=#757b87 width=1.5 dash=5 3");
        assertThat(swatches(curves, "quartiles")).hasSize(2).doesNotHaveDuplicates();
        Figure modules = ModuleUseFigure.of("blended", experiments, paper).orElseThrow();
        assertThat(swatches(modules, "ours")).endsWith("fill=#1a1a1a", "fill=#0072b2");
        assertThat(swatches(modules, "the paper's")).containsExactly("fill=#a9aeb8", "fill=#a9aeb8");
        for (Figure figure : List.of(medians, curves, modules)) {
            assertThat(figure.narrowSvg()).contains("width=\"380\"").contains("the paper's".replace("'", "&#39;"));
        }
    }

    @Test
    void curves_drawThePapersMedianOnTop_soThatItShowsWhereBothAgree() {
        String panel = LearningCurveFigure.panels("blended", experiments.subList(0, 1), paper)
                .svg();
        assertThat(panel.indexOf("stroke=\"#757b87\"")).isGreaterThan(panel.indexOf("stroke=\"#1a1a1a\""));
    }

    /**
     * The drawings between the text before a legend entry and the entry's text. Those of the first entry begin with the
     * data of the last panel.
     */
    private static List<String> swatches(Figure figure, String text) {
        List<String> lines = figure.svg().lines().toList();
        int end = lines.size() - 1;
        while (!lines.get(end).endsWith(">" + text.replace("'", "&#39;") + "</text>")) {
            end--;
        }
        int start = end;
        while (lines.get(start - 1).startsWith("<path")) {
            start--;
        }
        return lines.subList(start, end).stream()
                .map(path -> path.contains("stroke=")
                        ? "stroke=" + attribute(path, "stroke") + " width=" + attribute(path, "stroke-width") + " dash="
                                + attribute(path, "stroke-dasharray")
                        : "fill=" + attribute(path, "fill"))
                .toList();
    }

    private static String attribute(String element, String name) {
        int start = element.indexOf(" " + name + "=\"");
        return start < 0
                ? ""
                : element.substring(start + name.length() + 3, element.indexOf('"', start + name.length() + 3));
    }

    @Test
    void names_tellVersionAndKind() {
        assertThat(LearningCurveFigure.overview("blended", experiments, paper).name())
                .isEqualTo("blended-medians");
        assertThat(LearningCurveFigure.panels("", experiments, paper).name()).isEqualTo("curves");
    }

    @Test
    void moduleUse_withoutEvaluations_isNoFigure() throws IOException {
        RunFixture.run(base, "interleaved", "1M", 0, 1, 2);
        List<Experiment> unevaluated = ExperimentFinder.find(List.of(base.resolve("interleaved")));
        assertThat(ModuleUseFigure.of("interleaved", unevaluated, paper)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "1e17, 1e17",
        "-1e17, -1e17",
        "0, 1e300",
        "-1e308, 1e308",
        "-1.7976931348623157e308, 1.7976931348623157e308",
        "1e-300, 1e-300",
        "4.9e-324, 1e-320",
        "0, 0",
        "1, 1e17",
        "123456789.123, 123456789.124"
    })
    void curvesOfAnyNumbers_areDrawn(double first, double last) throws IOException {
        RunFixture.run(base, "interleaved", "1M", 0, first, last, first);
        List<Experiment> extreme = ExperimentFinder.find(List.of(base.resolve("interleaved")));
        for (Figure figure : List.of(
                LearningCurveFigure.overview("interleaved", extreme, paper),
                LearningCurveFigure.panels("interleaved", extreme, paper))) {
            assertThat(figure.svg()).doesNotContain("NaN", "Infinity").hasSizeLessThan(300_000);
            assertThat(figure.png()).isNotEmpty();
        }
    }

    @Test
    void curvesOfOneGeneration_areDrawn() throws IOException {
        RunFixture.run(base, "isolated", "MT", 0, 30000);
        List<Experiment> one = ExperimentFinder.find(List.of(base.resolve("isolated")));
        assertThat(LearningCurveFigure.panels("isolated", one, paper).svg()).contains("<svg");
        assertThat(LearningCurveFigure.overview("isolated", one, paper).svg()).contains("<svg");
    }
}
