package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import mmneat.analysis.HeadlessChromium;
import mmneat.analysis.results.RunFixture;
import mmneat.neat.ModuleLayout;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The report about experiments, and the replays to which it links. */
class ReportCommandTest extends CommandTest {

    @TempDir
    Path base;

    @BeforeEach
    void twoMethodsWithChampions() throws IOException {
        for (int run = 0; run < 2; run++) {
            Path one = RunFixture.run(base, "blended", "1M", run, 1000, 2000 + run);
            Path two = RunFixture.run(base, "blended", "2M", run, 1500, 4000 + run);
            RunFixture.evaluation(one, 1800 + run, 10);
            RunFixture.evaluation(two, 3500 + run, 90, 10);
            RunFixture.champion(one, ModuleLayout.single(1), run);
            RunFixture.champion(two, ModuleLayout.withPreferenceNeurons(2, 1), run);
        }
    }

    @Test
    void report_opensFromDisk_withFiguresStatisticsChampionsAndReplays() throws IOException {
        Path page = base.resolve("report.html");
        int code = execute(
                "report",
                base.resolve("blended").toString(),
                "out=" + page,
                "figures=" + base.resolve("pictures"),
                "replays=best",
                "title=Two <methods>");
        assertThat(errors.toString()).isEmpty();
        assertThat(code).isZero();
        assertThat(base.resolve("pictures"))
                .isDirectoryContaining("glob:**blended-curves.svg")
                .isDirectoryContaining("glob:**blended-medians.png")
                .isDirectoryContaining("glob:**blended-modules.svg");
        try (HeadlessChromium browser = HeadlessChromium.start()) {
            browser.open(page);
            assertThat(browser.text("h1")).isEqualTo("Two <methods>");
            assertThat(browser.evaluate("document.querySelectorAll('figure').length")
                            .asInt())
                    .isEqualTo(3);
            assertThat(browser.text("#statistics")).contains("Kruskal-Wallis").contains("2M (paper)");
            assertThat(browser.text("#champions")).contains("3,501").contains("90.0 %");
            assertThat(browser.text("#settings")).contains("startingModes");
            assertThat(browser.evaluate("document.querySelectorAll('#champions a').length")
                            .asInt())
                    .isEqualTo(2);
            Path replay = base.resolve(browser.evaluate("document.querySelector('#champions a').getAttribute('href')")
                    .asText());
            browser.open(replay);
            browser.waitUntil("window.player !== undefined");
            assertThat(browser.text("h1")).isEqualTo("blended 1M, run 1");
            browser.press("End");
            assertThat(browser.text("#score")).isNotEqualTo("0");
            assertThat(browser.complaints()).isEmpty();
        }
    }

    @Test
    void report_onScreensOfAllSizes_isReadable() throws IOException {
        Path page = base.resolve("report.html");
        assertThat(execute("report", base.resolve("blended").toString(), "out=" + page, "replays=none"))
                .isZero();
        try (HeadlessChromium browser = HeadlessChromium.start()) {
            for (int[] size : new int[][] {{1366, 620}, {844, 390}, {390, 844}, {360, 640}}) {
                browser.resize(size[0], size[1], size[0] < 1000);
                browser.open(page);
                assertThat(number(browser, "document.documentElement.scrollWidth - innerWidth"))
                        .as("sideways scrolling")
                        .isLessThanOrEqualTo(0);
                assertThat(number(
                                browser,
                                "Math.min(...[...document.querySelectorAll('figure svg')]"
                                        + ".filter(svg => svg.getBoundingClientRect().width)"
                                        + ".flatMap(svg => [...svg.querySelectorAll('text')].map(text =>"
                                        + " text.getAttribute('font-size') * svg.getBoundingClientRect().width"
                                        + " / svg.viewBox.baseVal.width)))"))
                        .as("smallest letters in pixels at %d x %d", size[0], size[1])
                        .isGreaterThan(9);
                openNetwork_keepsTheRowInView(browser);
            }
            assertThat(browser.complaints()).isEmpty();
        }
    }

    private static void openNetwork_keepsTheRowInView(HeadlessChromium browser) {
        String row = "document.querySelector('#champions input').closest('tr')";
        browser.evaluate(row + ".scrollIntoView({block: 'center', behavior: 'instant'})");
        String top = row + ".cells[0].getBoundingClientRect().top";
        double before = number(browser, top);
        browser.evaluate("document.querySelector('#champions input').click()");
        assertThat(number(browser, top)).isEqualTo(before).isBetween(0.0, number(browser, "innerHeight"));
        assertThat(number(browser, row + ".getBoundingClientRect().height")).isLessThan(80);
        String drawing = row + ".nextElementSibling.querySelector('.drawing').getBoundingClientRect()";
        assertThat(number(browser, drawing + ".top")).isLessThan(number(browser, "innerHeight"));
        assertThat(number(browser, drawing + ".left")).isNotNegative();
        assertThat(number(browser, drawing + ".right")).isLessThanOrEqualTo(number(browser, "innerWidth"));
        assertThat(number(browser, drawing + ".height")).isGreaterThan(100);
    }

    @Test
    void report_ofADarkScreen_isDark() throws IOException {
        Path page = base.resolve("report.html");
        assertThat(execute("report", base.resolve("blended").toString(), "out=" + page, "replays=none"))
                .isZero();
        try (HeadlessChromium browser = HeadlessChromium.start()) {
            String background = "Number(getComputedStyle(document.body).backgroundColor.match(/\\d+/)[0])";
            String ink = "Number(getComputedStyle(document.querySelector('td')).color.match(/\\d+/)[0])";
            browser.open(page);
            assertThat(number(browser, background)).isEqualTo(255);
            assertThat(number(browser, ink)).isLessThan(100);
            browser.preferDark(true);
            assertThat(number(browser, background)).isLessThan(40);
            assertThat(number(browser, ink)).isGreaterThan(200);
            assertThat(browser.evaluate("getComputedStyle(document.querySelector('figure svg')).filter")
                            .asText())
                    .contains("invert");
        }
    }

    private static double number(HeadlessChromium browser, String expression) {
        return browser.evaluate(expression).asDouble();
    }

    @Test
    void report_withoutReplays_linksToNone() throws IOException {
        Path page = base.resolve("report.html");
        assertThat(execute("report", base.resolve("blended").toString(), "out=" + page, "replays=none"))
                .isZero();
        assertThat(Files.readString(page)).doesNotContain(">watch<");
        assertThat(base.resolve("report-replays")).doesNotExist();
    }
}
