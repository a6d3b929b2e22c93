package mmneat.mspacman;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.GZIPInputStream;
import mmneat.GoldenData;
import mmneat.evolution.Evaluation;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/** Whole evaluations and single decisions equal the original's, random draws included. */
@Tag("conformance")
class GoldenEvaluationsTest {

    @Test
    void evaluation_equalsTheOriginals_inEveryRecordedCase() throws IOException {
        List<GoldenEvaluation> all = GoldenEvaluation.all();
        assertThat(all).hasSize(12);
        for (GoldenEvaluation golden : all) {
            MsPacManTask task = new MsPacManTask(golden.settings());
            ResumableRandom random = new ResumableRandom(golden.globalSeed());
            TrialScores trials = new TrialScores();
            Evaluation evaluation = task.evaluate(golden.genotype(), random, trials);
            for (int i = 0; i < trials.objectives.size(); i++) {
                JsonNode expected = golden.json().get("trialResults").get(i);
                assertThat(trials.objectives.get(i))
                        .as("%s trial %d", golden.name(), i)
                        .containsExactly(GoldenEvaluation.doubles(expected.get("objectives")));
                assertThat(trials.others.get(i))
                        .as("%s trial %d", golden.name(), i)
                        .containsExactly(GoldenEvaluation.doubles(expected.get("other")));
            }
            assertThat(evaluation.objectives()).as(golden.name()).containsExactly(golden.doubles("objectives"));
            assertThat(evaluation.otherScores()).as(golden.name()).containsExactly(golden.doubles("other"));
            assertThat(evaluation.moduleUsage()).as(golden.name()).containsExactly(golden.ints("genotypeModuleUsage"));
            assertThat(random.nextLong())
                    .as(golden.name())
                    .isEqualTo(golden.json().get("nextLongAfterwards").asLong());
        }
    }

    private static final class TrialScores implements EvaluationObserver {
        private final List<double[]> objectives = new ArrayList<>();
        private final List<double[]> others = new ArrayList<>();

        @Override
        public void trialOver(int trial, double[] trialObjectives, double[] trialOthers) {
            objectives.add(trialObjectives);
            others.add(trialOthers);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"blended-2M", "interleaved-MT", "isolated-2M"})
    void everyStep_equalsTheOriginals_inTheFirstGame(String name) throws IOException {
        Path file = GoldenData.folder("sensors").resolve("trace-" + name + ".jsonl.gz");
        GoldenEvaluation golden = GoldenEvaluation.named(name);
        try (BufferedReader lines = new BufferedReader(
                new InputStreamReader(new GZIPInputStream(Files.newInputStream(file)), StandardCharsets.UTF_8))) {
            TraceComparison comparison = new TraceComparison(name, lines);
            new MsPacManTask(golden.settings().withTrials(1))
                    .evaluate(golden.genotype(), new ResumableRandom(golden.globalSeed()), comparison);
            assertThat(comparison.steps).isGreaterThan(400);
            assertThat(lines.readLine()).isNull();
        }
    }

    /** Compares the steps of the first game with a trace. */
    private static final class TraceComparison implements EvaluationObserver {

        private final ObjectMapper json = new ObjectMapper();
        private final String name;
        private final BufferedReader lines;
        private int steps;
        private boolean firstGameIsOver;
        private int node;
        private int totalTime;
        private int levelTime;

        private TraceComparison(String name, BufferedReader lines) throws IOException {
            this.name = name;
            this.lines = lines;
            lines.readLine();
        }

        @Override
        public void gameStarted(TrialGame setting, Game game) {
            remember(game);
        }

        private void remember(Game game) {
            node = game.getPacmanCurrentNodeIndex();
            totalTime = game.getTotalTime();
            levelTime = game.getCurrentLevelTime();
        }

        @Override
        public void stepPlayed(Game game, DirectionEvaluator player) {
            if (firstGameIsOver) {
                return;
            }
            steps++;
            try {
                compare(json.readTree(lines.readLine()), game, player);
            } catch (IOException e) {
                throw new AssertionError(name + ": the trace ends before step " + steps, e);
            }
            remember(game);
        }

        private void compare(JsonNode expected, Game game, DirectionEvaluator player) {
            String step = name + " step " + steps;
            assertThat(totalTime).as(step).isEqualTo(expected.get("t").asInt());
            assertThat(levelTime).as(step).isEqualTo(expected.get("lt").asInt());
            assertThat(node).as(step).isEqualTo(expected.get("node").asInt());
            for (int d = 0; d < 4; d++) {
                JsonNode preference = expected.get("pref").get(d);
                assertThat(player.wasOpen(d)).as(step).isEqualTo(!preference.isNull());
                if (player.wasOpen(d)) {
                    assertThat(player.preference(d)).as(step).isEqualTo(preference.asDouble());
                    assertThat(player.lastModule(d))
                            .as(step)
                            .isEqualTo(expected.get("mod").get(d).asInt());
                }
            }
            if (game.getCurrentLevelTime() > 1) {
                assertThat(game.getPacmanLastMoveMade())
                        .as(step)
                        .isEqualTo(MOVE.valueOf(expected.get("move").asText()));
            }
            assertThat(game.getScore()).as(step).isEqualTo(expected.get("score").asInt());
        }

        @Override
        public void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {
            firstGameIsOver = true;
        }
    }
}
