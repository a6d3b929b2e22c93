package mmneat.analysis.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import mmneat.analysis.HeadlessChromium;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The replay page as its readers see it. */
class ReplayPageTest {

    /** As many as the sensors of the shipped champions. */
    private static final int INPUTS = 30;

    private static final int LAST = 2 * SyntheticReplay.STEPS_PER_LEVEL - 1;

    @TempDir
    static Path folder;

    private static HeadlessChromium browser;
    private static Path page;

    @BeforeAll
    static void writePage() throws IOException {
        page = folder.resolve("replay.html");
        Files.writeString(page, ReplayPage.html(SyntheticReplay.record()));
        browser = HeadlessChromium.start();
        browser.resize(1280, 800, false);
    }

    /** The page is loaded and its network was drawn once. */
    private static final String DRAWN = "window.player !== undefined && player.networkView.at !== undefined"
            + " && player.networkView.at.row !== undefined";

    @AfterAll
    static void closeBrowser() throws IOException {
        if (browser != null) {
            browser.close();
        }
    }

    @BeforeEach
    void openPage() {
        browser.open(page);
        browser.waitUntil(DRAWN);
    }

    @AfterEach
    void readerSeesNoErrors_andNothingIsFetched() {
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void page_opened_showsHeadingAndStart() {
        assertThat(browser.text("h1")).isEqualTo("A <square> & its \"runner\"");
        assertThat(browser.text("header p")).isEqualTo("made for a test </script>");
        assertThat(browser.text("#position")).isEqualTo("0 / " + LAST);
        assertThat(browser.text("#score")).isEqualTo("0");
        assertThat(browser.text("#pills")).isEqualTo("40");
        assertThat(browser.text("#modules")).contains("Module 1 · 50.2%").contains("Module 2 · 49.8%");
    }

    @Test
    void playButton_playsToTheEnd_andShowsTheScore() {
        browser.evaluate("player.setSpeed(16)");
        browser.click("#poster");
        browser.waitUntil("player.at > 0 && player.playing");
        browser.waitUntil("!player.playing");
        assertThat(browser.text("#position")).isEqualTo(LAST + " / " + LAST);
        assertThat(browser.text("#score")).isEqualTo("1,000");
        assertThat(browser.text("#pills")).isEqualTo("0");
        assertThat(browser.text("#outcome")).isEqualTo("All mazes cleared");
    }

    @Test
    void timeline_dragged_scrubs() {
        browser.drag("#timeline", 0.1, 0.5);
        double step = browser.evaluate("player.step").asDouble();
        assertThat(step).isBetween(LAST * 0.48, LAST * 0.52);
        assertThat(browser.text("#maze-label")).isIn("Level 1 maze", "Level 2 maze");
        browser.drag("#timeline", 0.5, 1.0);
        assertThat(browser.text("#score")).isEqualTo("1,000");
        browser.drag("#timeline", 1.0, 0.0);
        assertThat(browser.text("#score")).isEqualTo("0");
    }

    @Test
    void keyboard_stepsJumpsAndPlays() {
        browser.press("ArrowRight");
        browser.press("ArrowRight");
        assertThat(browser.text("#position")).isEqualTo("2 / " + LAST);
        assertThat(browser.text("#score")).isEqualTo("10");
        browser.press("ArrowLeft");
        assertThat(browser.text("#position")).isEqualTo("1 / " + LAST);
        browser.press("n");
        assertThat(browser.text("#position")).isEqualTo(SyntheticReplay.STEPS_PER_LEVEL + " / " + LAST);
        assertThat(browser.text("#pills")).isEqualTo("40");
        browser.press("End");
        assertThat(browser.text("#score")).isEqualTo("1,000");
        browser.press("Home");
        assertThat(browser.text("#score")).isEqualTo("0");
        browser.press(" ");
        browser.waitUntil("player.playing && player.at > 1");
        browser.press(" ");
        assertThat(browser.evaluate("player.playing").asBoolean()).isFalse();
    }

    @Test
    void canvases_areDrawn_onLaptopAndPhone() {
        for (int[] size : new int[][] {{1280, 800, 0}, {390, 844, 1}}) {
            browser.resize(size[0], size[1], size[2] == 1);
            browser.press("End");
            for (String canvas : new String[] {"maze-canvas", "network-canvas", "timeline-canvas"}) {
                // An empty canvas of these sizes is a few hundred bytes of PNG.
                browser.waitUntil("document.getElementById('" + canvas + "').toDataURL().length > 3000");
            }
            int overflow = browser.evaluate("document.documentElement.scrollWidth - innerWidth")
                    .asInt();
            assertThat(overflow).as("sideways scrolling").isLessThanOrEqualTo(0);
        }
        browser.resize(1280, 800, false);
    }

    @ParameterizedTest
    @CsvSource({
        "1366, 620, 0",
        "1920, 1000, 0",
        "1024, 600, 0",
        "844, 390, 1",
        "667, 375, 1",
        "390, 844, 1",
        "360, 740, 1"
    })
    void page_onScreen_hasNothingCutOrCovered(int width, int height, int phone) throws IOException {
        Path games = folder.resolve("games.html");
        Files.writeString(games, ReplayPage.html(SyntheticReplay.isolatedGames(INPUTS)));
        browser.resize(width, height, phone == 1);
        for (Path shown : new Path[] {page, games}) {
            browser.open(shown);
            browser.waitUntil(DRAWN);
            browser.evaluate("player.move(200)");
            assertThat(number("document.documentElement.scrollWidth - innerWidth"))
                    .as("sideways scrolling")
                    .isLessThanOrEqualTo(0);
            assertThat(browser.evaluate("[...document.querySelectorAll('.figure span, .figure b')]"
                            + ".filter(e => e.offsetParent && e.scrollWidth > e.clientWidth).map(e => e.textContent)"))
                    .as("cut texts")
                    .isEmpty();
            assertThat(number("document.querySelector('footer').getBoundingClientRect().bottom - innerHeight"))
                    .as("controls below the window")
                    .isLessThan(1);
            // After scrolling to its end, the last row of the list of sensors is above the controls.
            browser.evaluate(
                    "document.querySelector('#network .key').scrollIntoView({block: 'end', behavior: 'instant'})");
            browser.evaluate("scrollTo(0, document.documentElement.scrollHeight)");
            assertThat(overlap("#network-canvas", "footer")).isLessThanOrEqualTo(0);
            assertThat(number("player.networkView.at.row"))
                    .as("height of a sensor's row")
                    .isGreaterThan(9.5);
            browser.evaluate("scrollTo(0, 0)");
            assertThat(number("document.querySelector('#maze-canvas').getBoundingClientRect().width"))
                    .as("width of the maze")
                    .isGreaterThan(300);
            assertThat(overlap("#maze-canvas", width > height && width < 881 ? "#board" : "footer"))
                    .as("controls over the maze")
                    .isLessThanOrEqualTo(0);
        }
        browser.resize(1280, 800, false);
    }

    @Test
    void allSensors_areInViewAtOnce_onALaptop() throws IOException {
        Path games = folder.resolve("laptop.html");
        Files.writeString(games, ReplayPage.html(SyntheticReplay.isolatedGames(INPUTS)));
        browser.resize(1366, 620, false);
        browser.open(games);
        browser.waitUntil(DRAWN);
        assertThat(number("(m => m.scrollHeight - m.clientHeight)(document.querySelector('#network'))"))
                .isLessThanOrEqualTo(0);
        assertThat(number("document.documentElement.scrollHeight - innerHeight"))
                .isLessThanOrEqualTo(0);
        browser.resize(1280, 800, false);
    }

    @Test
    void fixedDirection_showsTheNetworkInEveryStep() {
        browser.evaluate("player.setDirection(0)");
        assertThat(number("player.recording.column.preference0.filter(value => value === WALL).length"))
                .as("steps with a wall above")
                .isGreaterThan(100);
        assertThat(browser.evaluate(
                                "[...player.recording.column.preference0.keys()]"
                                        + ".every(step => player.networkView.isOpen(0, player.networkView.networkStep(0, step)))")
                        .asBoolean())
                .isTrue();
        assertThat(browser.evaluate("player.networkView.isOpen(0, 100)").asBoolean())
                .isFalse();
        String network = "(c => { player.networkView.draw(player.step); const d = devicePixelRatio;"
                + " const p = c.getContext('2d').getImageData(player.networkView.at.first * d, 60 * d, 200 * d, 200 * d).data;"
                + " return p.filter((v, i) => i % 4 < 3 && v > 40).length; })(document.getElementById('network-canvas'))";
        browser.evaluate("player.move(100)");
        assertThat(number(network)).as("pixels of the network").isGreaterThan(500);
    }

    @Test
    void help_explainsThePage_beforeTheKeys() {
        browser.click("#help-button");
        assertThat(browser.text("#help h2")).isEqualTo("How to read this page");
        assertThat(browser.text("#help dl")).contains("Output").contains("highest output");
        assertThat(browser.evaluate("document.querySelector('#help').open").asBoolean())
                .isTrue();
    }

    private static double number(String expression) {
        return browser.evaluate(expression).asDouble();
    }

    /** Height in CSS pixels that two elements have in common; negative: the distance between them. */
    private static double overlap(String one, String other) {
        return number("((a, b) => Math.min(Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top),"
                + " Math.min(a.right, b.right) - Math.max(a.left, b.left)))"
                + "(document.querySelector('" + one + "').getBoundingClientRect(), document.querySelector('" + other
                + "').getBoundingClientRect())");
    }

    @Test
    void recording_unpackedInTheBrowser_equalsTheRecordedGame() {
        assertThat(browser.evaluate("[...player.recording.column.node]")
                        .get(LAST)
                        .asInt())
                .isEqualTo(SyntheticReplay.STEPS_PER_LEVEL - 1);
        assertThat(browser.evaluate("player.networkView.value('sensor', 1, 1, 80)")
                        .asDouble())
                .isBetween(0.49, 0.51);
        assertThat(browser.evaluate("player.networkView.preference(player.recording.column.choice[30], 30)")
                        .asDouble())
                .isBetween(0.74, 0.76);
        assertThat(browser.evaluate("player.networkView.value('node', 1, 0, 10)")
                        .asDouble())
                .isBetween(Math.sin(1) - 0.02, Math.sin(1) + 0.02);
    }
}
