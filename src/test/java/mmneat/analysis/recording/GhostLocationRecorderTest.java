package mmneat.analysis.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.StringReader;
import java.util.Arrays;
import mmneat.analysis.evaluation.ShippedChampions;
import mmneat.mspacman.DirectionEvaluator;
import mmneat.mspacman.EvaluationObserver;
import mmneat.mspacman.GameEnd;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TrialGame;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import pacman.game.Game;
import pacman.game.GhostLocations;

/** Situations are recorded as the isolated task needs them. */
class GhostLocationRecorderTest {

    private static final MsPacManTaskSettings BLENDED = MsPacManTaskSettings.blended();
    private static final int NO_LIMIT = 1_000_000;

    private final Genotype champion = ShippedChampions.read("blended").genotype();

    @Test
    void situations_areTheProperlyEatenPowerPills() {
        int[] counts = new int[2];
        EvaluationObserver counter = new EvaluationObserver() {
            private int level;
            private int properlyEaten;

            @Override
            public void gameStarted(TrialGame setting, Game game) {
                level = 0;
                properlyEaten = 0;
            }

            @Override
            public void stepPlayed(Game game, DirectionEvaluator player) {
                // A power pill that ends its level cannot be named from outside, so the recorder leaves it out.
                boolean endsLevel = game.getCurrentLevel() != level;
                counts[1] += endsLevel ? game.getProperlyEatenPowerPills() - properlyEaten : 0;
                level = game.getCurrentLevel();
                properlyEaten = game.getProperlyEatenPowerPills();
            }

            @Override
            public void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {
                counts[0] += game.getProperlyEatenPowerPills();
            }
        };
        GhostLocationRecorder recorder = new GhostLocationRecorder(BLENDED, champion, NO_LIMIT, 7);
        ResumableRandom random = new ResumableRandom(7);
        for (int game = 0; game < 10; game++) {
            recorder.playGame(0);
            new MsPacManTask(BLENDED.withTrials(1)).evaluate(champion, random, counter);
        }
        assertThat(recorder.recorded()).isPositive().isEqualTo(counts[0] - counts[1]);
    }

    @Test
    void sameSeed_sameRecording() {
        assertThat(recording(3)).isEqualTo(recording(3)).isNotEqualTo(recording(4));
    }

    private String recording(long seed) {
        GhostLocationRecorder recorder = new GhostLocationRecorder(BLENDED, champion, 2, seed);
        for (int game = 0; game < 8; game++) {
            recorder.playGame(recorder.scarcestMaze());
        }
        return recorder.text();
    }

    @Test
    void recorder_reportsMissingObservations_untilItIsComplete() {
        GhostLocationRecorder recorder = new GhostLocationRecorder(BLENDED, champion, 1, 0);
        assertThat(recorder.missing()).startsWith("maze 0 power pill 0 (0 of 1), maze 0 power pill 1 (0 of 1)");
        assertThat(recorder.scarcestPowerPill()).isEqualTo("maze 0 power pill 0 (0 of 1)");
        while (!recorder.isComplete() && recorder.games() < 1000) {
            recorder.playGame(recorder.scarcestMaze());
        }
        assertThat(recorder.isComplete()).isTrue();
        assertThat(recorder.missing()).isEmpty();
        assertThat(recorder.recorded()).isEqualTo(16).isEqualTo(recorder.wantedInAll());
        assertThat(recorder.text().lines().map(line -> line.substring(0, 3)).toList())
                .hasSize(16)
                .doesNotHaveDuplicates()
                .isSorted();
    }

    @Test
    void text_isReadAsGhostLocations() throws IOException {
        GhostLocationRecorder recorder = new GhostLocationRecorder(BLENDED, champion, 1, 0);
        while (!recorder.isComplete() && recorder.games() < 1000) {
            recorder.playGame(recorder.scarcestMaze());
        }
        String hundredfold = String.join("", java.util.Collections.nCopies(GhostLocations.SITUATIONS, recorder.text()));
        GhostLocations read = GhostLocations.read("recorded", new StringReader(hundredfold));
        MsPacManTask task = new MsPacManTask(MsPacManTaskSettings.isolated(read).withTrials(1));
        Genotype isolated = ShippedChampions.read("isolated").genotype();
        assertThat(task.evaluate(isolated, new ResumableRandom(1)).outcomes().steps())
                .isPositive();
    }

    @Test
    void noObservationRequested_isRefused() {
        assertThatThrownBy(() -> new GhostLocationRecorder(BLENDED, champion, 0, 0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("at least 1");
    }

    @Test
    void shippedRecording_startsIsolatedGames() {
        MsPacManTask task = new MsPacManTask(
                MsPacManTaskSettings.isolated(GhostLocations.shipped()).withTrials(1));
        Genotype isolated = ShippedChampions.read("isolated").genotype();
        assertThat(Arrays.stream(task.evaluate(isolated, new ResumableRandom(1)).objectives()))
                .allMatch(score -> score >= 0);
    }
}
