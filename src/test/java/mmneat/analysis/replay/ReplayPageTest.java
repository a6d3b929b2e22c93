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

/** The replay page as its readers see it. */
class ReplayPageTest {

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

    @AfterAll
    static void closeBrowser() throws IOException {
        if (browser != null) {
            browser.close();
        }
    }

    @BeforeEach
    void openPage() {
        browser.open(page);
        browser.waitUntil("window.player !== undefined");
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
        assertThat(browser.text("#maze-label")).isIn("Level 1", "Level 2");
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
            for (String canvas : new String[] {"maze-canvas", "mind-canvas", "timeline-canvas"}) {
                // An empty canvas of these sizes is a few hundred bytes of PNG.
                browser.waitUntil("document.getElementById('" + canvas + "').toDataURL().length > 3000");
            }
            int overflow = browser.evaluate("document.documentElement.scrollWidth - innerWidth")
                    .asInt();
            assertThat(overflow).as("sideways scrolling").isLessThanOrEqualTo(0);
        }
        browser.resize(1280, 800, false);
    }

    @Test
    void recording_unpackedInTheBrowser_holdsWhatWasRecorded() {
        assertThat(browser.evaluate("[...player.recording.column.node]")
                        .get(LAST)
                        .asInt())
                .isEqualTo(SyntheticReplay.STEPS_PER_LEVEL - 1);
        assertThat(browser.evaluate("player.mind.value('sensor', 1, 1, 80)").asDouble())
                .isBetween(0.49, 0.51);
        assertThat(browser.evaluate("player.mind.preference(player.recording.column.choice[30], 30)")
                        .asDouble())
                .isBetween(0.74, 0.76);
        assertThat(browser.evaluate("player.mind.value('node', 1, 0, 10)").asDouble())
                .isBetween(Math.sin(1) - 0.02, Math.sin(1) + 0.02);
    }
}
