package mmneat.analysis.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import mmneat.analysis.HeadlessChromium;
import mmneat.analysis.evaluation.SensorNames;
import mmneat.evolution.Evaluation;
import mmneat.mspacman.DirectionEvaluator;
import mmneat.mspacman.EvaluationObserver;
import mmneat.mspacman.GameEnd;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TrialGame;
import mmneat.neat.Genotype;
import mmneat.neat.InitialNetworks;
import mmneat.neat.ModuleLayout;
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
    void shadowNetworks_wantWhatThePlayerWants_inEveryStep() {
        for (int seed = 0; seed < 5; seed++) {
            Genotype genotype = network(seed, ModuleLayout.withPreferenceNeurons(2, 1));
            ReplayNetwork picture = NetworkPicture.of(genotype, List.copyOf(new MsPacManTask(BLENDED).inputLabels()));
            ReplayStep step = new ReplayStep(picture);
            ShadowNetworks shadow = new ShadowNetworks(BLENDED, genotype);
            int[] compared = {0};
            new MsPacManTask(BLENDED).evaluate(genotype, new ResumableRandom(seed), new EvaluationObserver() {
                @Override
                public void gameStarted(TrialGame setting, Game game) {
                    shadow.startGame();
                    shadow.think(game, step);
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
                        shadow.think(game, step);
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

    @Test
    void sensorNames_areShortAndAllDifferent() {
        List<String> names = SensorNames.of(new MsPacManTask(BLENDED).inputLabels());
        assertThat(names).hasSize(30).doesNotHaveDuplicates().contains("Ghost 1 approaching", "Pills in 30 steps");
        assertThat(names).allSatisfy(name -> assertThat(name.length()).isLessThan(24));
    }
}
