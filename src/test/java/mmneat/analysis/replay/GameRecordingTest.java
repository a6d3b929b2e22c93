package mmneat.analysis.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import mmneat.analysis.HeadlessChromium;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.ChampionLabels;
import mmneat.analysis.evaluation.PlayerSettings;
import mmneat.analysis.evaluation.Rules;
import mmneat.analysis.evaluation.SensorNames;
import mmneat.analysis.evaluation.ShippedChampions;
import mmneat.evolution.Evaluation;
import mmneat.mspacman.DirectionEvaluator;
import mmneat.mspacman.EvaluationObserver;
import mmneat.mspacman.GameEnd;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TaskVersion;
import mmneat.mspacman.TrialGame;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.neat.variation.InitialNetworks;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import pacman.game.Game;

class GameRecordingTest {

    private static final MsPacManTaskSettings BLENDED =
            MsPacManTaskSettings.blended().withTrials(1);

    @TempDir
    Path folder;

    private static Genotype network(long seed, ModuleLayout layout) {
        return new InitialNetworks(30, layout).create(1, new ResumableRandom(seed));
    }

    @Test
    void independentActivations_chooseThePlayersMove_inEveryStep() {
        for (int seed = 0; seed < 5; seed++) {
            Genotype genotype = network(seed, ModuleLayout.withPreferenceNeurons(2, 1));
            ReplayNetwork picture = NetworkPicture.of(genotype, ChampionLabels.of(BLENDED, genotype.layout()));
            ReplayStep step = new ReplayStep(picture);
            FullNetworkEvaluator networks = new FullNetworkEvaluator(BLENDED, genotype);
            int[] compared = {0};
            new MsPacManTask(BLENDED).evaluate(genotype, new ResumableRandom(seed), new EvaluationObserver() {
                @Override
                public void gameStarted(TrialGame setting, Game game) {
                    networks.startGame();
                    networks.evaluate(game, step);
                }

                @Override
                public void stepPlayed(Game game, DirectionEvaluator player) {
                    for (int d = 0; d < 4; d++) {
                        assertThat(step.open[d]).isEqualTo(player.wasOpen(d));
                        if (step.open[d]) {
                            // Outputs are policy 0, preference 0, policy 1, preference 1; there are no hidden nodes.
                            assertThat(step.activations[d][2 * player.lastModule(d)])
                                    .isEqualTo(player.preference(d));
                            compared[0]++;
                        }
                    }
                    if (!game.gameOver()) {
                        networks.evaluate(game, step);
                    }
                }

                @Override
                public void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {
                    assertThat(compared[0]).isGreaterThan(100);
                }
            });
        }
    }

    @Test
    void recordedGame_endsInTheBrowserWithTheScoreOfTheEvaluation() throws IOException {
        Genotype genotype = network(3, ModuleLayout.withPreferenceNeurons(3, 1));
        Evaluation evaluation = new MsPacManTask(BLENDED).evaluate(genotype, new ResumableRandom(7));
        Replay replay = GameRecording.record(BLENDED, genotype, 7, new ReplayTitle("a game", "seed 7"));
        assertThat(replay.finalScore()).isEqualTo((int) evaluation.otherScores()[0]);
        assertThat(replay.steps()).isEqualTo((int) evaluation.outcomes().steps());
        String html = ReplayPage.html(replay);
        assertThat(html.getBytes(StandardCharsets.UTF_8).length).isLessThan(3_000_000);
        Path page = folder.resolve("game.html");
        Files.writeString(page, html);
        try (HeadlessChromium browser = HeadlessChromium.start()) {
            browser.open(page);
            browser.waitUntil("window.player !== undefined");
            browser.press("End");
            assertThat(browser.text("#score").replace(",", "")).isEqualTo(String.valueOf(replay.finalScore()));
            assertThat(browser.text("#outcome")).contains(String.format("%,d points", replay.finalScore()));
            assertThat(browser.complaints()).isEmpty();
        }
    }

    private void open(HeadlessChromium browser, Replay replay) throws IOException {
        String html = ReplayPage.html(replay);
        assertThat(html.getBytes(StandardCharsets.UTF_8).length).isLessThan(3_000_000);
        browser.open(Files.writeString(folder.resolve("game.html"), html));
        browser.waitUntil("window.player !== undefined");
    }

    private static void assertNoSidewaysScrolling(HeadlessChromium browser) {
        for (int[] size : new int[][] {{1366, 768, 0}, {390, 844, 1}, {844, 390, 1}}) {
            browser.resize(size[0], size[1], size[2] == 1);
            assertThat(browser.evaluate("document.documentElement.scrollWidth - innerWidth")
                            .asInt())
                    .isLessThanOrEqualTo(0);
        }
    }

    @Test
    void isolatedTrial_showsItsFiveGames_andTheirScoresTogether() throws IOException {
        Champion champion = ShippedChampions.read("isolated");
        MsPacManTaskSettings settings = PlayerSettings.of(champion, Optional.empty(), Rules.TRAINING, Optional.empty());
        Evaluation evaluation = new MsPacManTask(settings).evaluate(champion.genotype(), new ResumableRandom(2));
        int sum = (int) evaluation.otherScores()[0];
        Replay replay = GameRecording.record(settings, champion.genotype(), 2, new ReplayTitle("five games", ""));
        assertThat(replay.finalScore()).isEqualTo(sum);
        assertThat(replay.steps()).isEqualTo((int) evaluation.outcomes().steps());
        try (HeadlessChromium browser = HeadlessChromium.start()) {
            open(browser, replay);
            assertThat(browser.evaluate("player.recording.gameStarts.length").asInt())
                    .isEqualTo(5);
            assertThat(browser.text("#maze-label")).isEqualTo("Pills maze");
            assertThat(browser.text("#maze")).isEqualTo("A");
            browser.evaluate("player.setSpeed(16)");
            browser.press(" ");
            // The replay pauses at the end of the first game and shows how it ended.
            browser.waitUntil("!document.getElementById('outcome').hidden");
            assertThat(browser.evaluate("player.step").asInt())
                    .isEqualTo(browser.evaluate("player.recording.gameStarts[1] - 1")
                            .asInt());
            String ofPillGame = browser.text("#score");
            assertThat(browser.text("#outcome")).contains(ofPillGame + " points");
            browser.waitUntil("player.step > player.recording.gameStarts[1]");
            browser.press(" ");
            assertThat(browser.text("#maze-label")).isEqualTo("Ghosts 1 maze");
            browser.press("End");
            assertThat(browser.text("#total")).isEqualTo(String.format(Locale.ROOT, "%,d", sum));
            assertThat(browser.text("#outcome"))
                    .contains(browser.text("#score") + " points")
                    .endsWith(String.format(Locale.ROOT, "%,d in all 5 games", sum));
            assertNoSidewaysScrolling(browser);
            assertThat(browser.complaints()).isEmpty();
        }
    }

    @Test
    void fourMazeGame_showsLivesLost_andEndsWithItsScore() throws IOException {
        Champion champion = ShippedChampions.read("interleaved");
        MsPacManTaskSettings settings =
                PlayerSettings.of(champion, Optional.empty(), Rules.FOUR_MAZE, Optional.empty());
        // In this game Ms. Pac-Man loses a life and still reaches all four mazes.
        long seed = 10;
        Evaluation evaluation = new MsPacManTask(settings).evaluate(champion.genotype(), new ResumableRandom(seed));
        String score = String.format(Locale.ROOT, "%,d", (int) evaluation.otherScores()[0]);
        Replay replay = GameRecording.record(settings, champion.genotype(), seed, new ReplayTitle("four mazes", ""));
        try (HeadlessChromium browser = HeadlessChromium.start()) {
            open(browser, replay);
            assertThat(browser.text("#lives")).isEqualTo("3");
            int deaths = browser.evaluate("player.recording.deaths.length").asInt();
            assertThat(deaths).isPositive();
            browser.evaluate("player.seek(player.recording.deaths[0])");
            assertThat(browser.text("#outcome")).startsWith("Caught · ");
            String before = browser.text("#lives");
            browser.press("ArrowRight");
            assertThat(Integer.parseInt(browser.text("#lives"))).isEqualTo(Integer.parseInt(before) - 1);
            browser.press("Home");
            for (int maze = 2; maze <= 4; maze++) {
                browser.press("n");
                assertThat(browser.text("#maze-label")).isEqualTo("Level " + maze + " maze");
            }
            browser.press("End");
            assertThat(browser.text("#score")).isEqualTo(score);
            assertThat(browser.text("#outcome")).endsWith(score + " points");
            assertNoSidewaysScrolling(browser);
            assertThat(browser.complaints()).isEmpty();
        }
    }

    @Test
    void longGame_keepsDetailsOfFewerSteps_butAllMovesAndScores() {
        Genotype genotype = network(3, ModuleLayout.withPreferenceNeurons(3, 1));
        ReplayTitle title = new ReplayTitle("a game", "seed 7");
        Replay whole = GameRecording.record(BLENDED, genotype, 7, title);
        Replay small = GameRecording.record(BLENDED, genotype, 7, title, whole.dataLength() * 3 / 4);
        assertThat(whole.json()).contains("\"detailEvery\":1,");
        assertThat(small.json()).containsPattern("\"detailEvery\":[248],");
        assertThat(small.dataLength()).isLessThanOrEqualTo(whole.dataLength() * 3 / 4);
        assertThat(small.steps()).isEqualTo(whole.steps());
        assertThat(small.finalScore()).isEqualTo(whole.finalScore());
    }

    @Test
    void modulesOfADivision_areNamedByTheirObservation() {
        MsPacManTaskSettings settings = PlayerSettings.of(
                new Champion(network(1, ModuleLayout.multitask(3, 1)), Path.of("mt3.json"), Optional.empty(), Map.of()),
                Optional.of(TaskVersion.BLENDED),
                Rules.TRAINING,
                Optional.empty());
        assertThat(ChampionLabels.of(settings, ModuleLayout.multitask(3, 1)).modules())
                .containsExactly("module 1: all edible", "module 2: all threats", "module 3: threats and edible");
        assertThat(ChampionLabels.of(settings, ModuleLayout.withPreferenceNeurons(2, 1))
                        .modules())
                .containsExactly("module 1", "module 2");
    }

    @Test
    void sensorNames_areShortAndAllDifferent() {
        List<String> names = SensorNames.of(new MsPacManTask(BLENDED).inputLabels());
        assertThat(names).hasSize(30).doesNotHaveDuplicates().contains("Ghost 1 approaching", "Pills in 30 steps");
        assertThat(names).allSatisfy(name -> assertThat(name.length()).isLessThan(24));
    }
}
