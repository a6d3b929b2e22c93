package mmneat.analysis.evaluation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import mmneat.analysis.results.ChampionEvaluation;
import mmneat.evolution.Evaluation;
import mmneat.experiment.UserError;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TaskVersion;
import mmneat.neat.ModuleLayout;
import mmneat.neat.io.GenotypeJson;
import mmneat.neat.variation.InitialNetworks;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import pacman.game.GhostLocations;

class ChampionEvaluatorTest {

    @TempDir
    Path base;

    private Path run;

    @BeforeEach
    void runWithAChampion() throws IOException {
        run = Files.createDirectories(base.resolve("2M0"));
        writeParameters("");
        Files.writeString(
                run.resolve("champion.json"),
                GenotypeJson.write(new InitialNetworks(30, ModuleLayout.withPreferenceNeurons(2, 1))
                        .create(7, new ResumableRandom(5))));
    }

    private void writeParameters(String more) throws IOException {
        Files.writeString(run.resolve("parameters.properties"), "task=blended\nmethod=2M\nrunNumber=0\n" + more + "\n");
    }

    private ChampionEvaluation evaluate(Rules rules, int games, int threads) throws InterruptedException {
        Champion champion = Champion.read(run);
        MsPacManTaskSettings settings = PlayerSettings.of(champion, Optional.empty(), rules, Optional.empty());
        try (ChampionEvaluator evaluator = new ChampionEvaluator(rules, games, 11, threads)) {
            return evaluator
                    .evaluate(List.of(new ChampionEvaluator.Entry(champion, settings)))
                    .get(0);
        }
    }

    private String table() throws IOException {
        return Files.readString(run.resolve("evaluation-training.csv"));
    }

    @Test
    void evaluation_isTheSame_whateverTheNetworkWasSelectedFor() throws Exception {
        evaluate(Rules.TRAINING, 5, 2);
        String table = table();
        for (String objectives : List.of("GameScore", "PillScore,GhostRewardScore", "PillScore,GameScore")) {
            Files.delete(run.resolve("evaluation-training.csv"));
            writeParameters("objectives=" + objectives);
            evaluate(Rules.TRAINING, 5, 2);
            assertThat(table()).as(objectives).isEqualTo(table);
        }
    }

    @Test
    void evaluation_isTheSame_forAnyNumberOfThreads() throws Exception {
        ChampionEvaluation one = evaluate(Rules.TRAINING, 50, 1);
        String table = table();
        Files.delete(run.resolve("evaluation-training.csv"));
        ChampionEvaluation three = evaluate(Rules.TRAINING, 50, 3);
        assertThat(table()).isEqualTo(table);
        assertThat(three).usingRecursiveComparison().isEqualTo(one);
        assertThat(table.lines()).hasSize(51);
    }

    @Test
    void table_hasAHeaderLineAndOneValuePerCell() throws Exception {
        evaluate(Rules.TRAINING, 3, 1);
        List<String> lines = table().lines().toList();
        String[] header = lines.get(0).split(",");
        int modules = Champion.read(run).genotype().modules();
        assertThat(header)
                .hasSize(9 + 6 * modules + 1)
                .startsWith("game", "seed", "score")
                .endsWith("evaluation");
        assertThat(lines).hasSize(4).allSatisfy(line -> assertThat(line.split(","))
                .hasSize(header.length));
        assertThat(lines.subList(1, 4))
                .allSatisfy(line -> assertThat(Arrays.stream(line.split(",")).limit(header.length - 1))
                        .allMatch(cell -> cell.matches("-?[0-9.]+|[A-Z_]+")));
    }

    @Test
    void gamesOfARunWithFixedSeeds_differAllTheSame() throws Exception {
        evaluate(Rules.TRAINING, 20, 1);
        String table = table();
        Files.delete(run.resolve("evaluation-training.csv"));
        writeParameters("deterministic=true");
        evaluate(Rules.TRAINING, 20, 1);
        assertThat(table()).isEqualTo(table);
    }

    @Test
    void gamesThatARuleOfPowerPillsEnds_areTold() throws Exception {
        writeParameters("dieOnImproperPowerPillEating=true");
        Files.writeString(
                run.resolve("champion.json"),
                GenotypeJson.write(ShippedChampions.read("blended").genotype()));
        evaluate(Rules.TRAINING, 40, 2);
        assertThat(table()).contains(",PUNISHED,", ",LOST_ALL_LIVES,").doesNotContain("GAME_TIME_LIMIT");
    }

    @Test
    void tableThatAnotherEvaluationWrites_isRefused_andLeftAlone() throws Exception {
        evaluate(Rules.TRAINING, 3, 1);
        String table = table();
        try (EvaluationFile other = new EvaluationFile(run.resolve("evaluation-training.csv"))) {
            assertThatThrownBy(() -> evaluate(Rules.TRAINING, 5, 1))
                    .isInstanceOf(UserError.class)
                    .hasMessage(run.resolve("evaluation-training.csv")
                            + ": another evaluation is writing this file; wait until it has finished");
            other.append(List.of());
        }
        assertThat(table()).isEqualTo(table);
        evaluate(Rules.TRAINING, 5, 1);
        assertThat(table()).startsWith(table).hasLineCount(6);
    }

    @Test
    void evaluationWithAnotherSeed_isKept_andBothCanBeTakenUpAgain() throws Exception {
        ChampionEvaluation larger = evaluate(Rules.TRAINING, 5, 1);
        String table = table();
        String summary = Files.readString(run.resolve("evaluation-training.json"));
        Champion champion = Champion.read(run);
        MsPacManTaskSettings settings = PlayerSettings.of(champion, Optional.empty(), Rules.TRAINING, Optional.empty());
        try (ChampionEvaluator evaluator = new ChampionEvaluator(Rules.TRAINING, 1, 12, 1);
                ChampionEvaluator.Evaluations started =
                        evaluator.begin(List.of(new ChampionEvaluator.Entry(champion, settings)))) {
            assertThat(started.remarks())
                    .hasSize(2)
                    .satisfiesExactly(
                            remark -> assertThat(remark)
                                    .startsWith(run.resolve("evaluation-training.csv")
                                            + ": held another evaluation (5 games; network 7 (")
                                    .endsWith("seed 11); kept as evaluation-training-old-1.csv"),
                            remark -> assertThat(remark)
                                    .isEqualTo(run.resolve("evaluation-training.json")
                                            + ": is the summary of other games; kept as"
                                            + " evaluation-training-old-1.json"));
            started.finish();
        }
        assertThat(table()).hasLineCount(2);
        assertThat(run.resolve("evaluation-training-old-1.csv")).hasContent(table);
        assertThat(run.resolve("evaluation-training-old-1.json")).hasContent(summary);

        assertThat(evaluate(Rules.TRAINING, 5, 1).meanScore()).isEqualTo(larger.meanScore());
        assertThat(table()).isEqualTo(table);
        assertThat(run.resolve("evaluation-training-old-2.csv")).content().hasLineCount(2);
    }

    @Test
    void summaryWithoutItsTable_isKept_onlyOnce() throws Exception {
        evaluate(Rules.TRAINING, 5, 1);
        String summary = Files.readString(run.resolve("evaluation-training.json"));
        for (int repetition = 0; repetition < 2; repetition++) {
            Files.delete(run.resolve("evaluation-training.csv"));
            Files.writeString(run.resolve("evaluation-training.json"), summary);
            evaluate(Rules.TRAINING, 2, 1);
        }
        assertThat(run.resolve("evaluation-training-old-1.json")).hasContent(summary);
        assertThat(run.resolve("evaluation-training-old-2.json")).doesNotExist();
    }

    @Test
    void summaryOfMoreGamesThanTheTableHas_isKept() throws Exception {
        evaluate(Rules.TRAINING, 5, 1);
        String summary = Files.readString(run.resolve("evaluation-training.json"));
        String table = table();
        Files.writeString(
                run.resolve("evaluation-training.csv"),
                String.join("\n", table.lines().limit(3).toList()) + "\n");
        evaluate(Rules.TRAINING, 5, 1);
        assertThat(run.resolve("evaluation-training-old-1.json")).doesNotExist();
        assertThat(table()).isEqualTo(table);

        Files.writeString(
                run.resolve("evaluation-training.csv"),
                String.join("\n", table.lines().limit(3).toList()) + "\n");
        assertThat(evaluate(Rules.TRAINING, 1, 1).games()).isEqualTo(2);
        assertThat(run.resolve("evaluation-training-old-1.json")).hasContent(summary);
    }

    @Test
    void damagedLine_isRefused_andTheTableLeftAlone() throws Exception {
        evaluate(Rules.TRAINING, 5, 1);
        List<String> lines = new ArrayList<>(table().lines().toList());
        lines.set(3, lines.get(3).replaceFirst("^2,", "2,x"));
        String damaged = String.join("\n", lines) + "\n";
        Files.writeString(run.resolve("evaluation-training.csv"), damaged);
        assertThatThrownBy(() -> evaluate(Rules.TRAINING, 5, 1))
                .isInstanceOf(UserError.class)
                .hasMessageStartingWith(run.resolve("evaluation-training.csv") + ", line 4: column seed: 'x")
                .hasMessageEndingWith("; delete the file to evaluate again");
        assertThat(table()).isEqualTo(damaged);
        Files.delete(run.resolve("evaluation-training.csv"));
        assertThat(evaluate(Rules.TRAINING, 5, 1).games()).isEqualTo(5);
    }

    @Test
    void interruptedEvaluation_goesOn_whereItStopped() throws Exception {
        evaluate(Rules.TRAINING, 50, 2);
        String whole = table();
        // Twenty complete games and a line that was cut off.
        int end = whole.lines().limit(21).mapToInt(line -> line.length() + 1).sum();
        Files.writeString(run.resolve("evaluation-training.csv"), whole.substring(0, end + 9));
        Champion champion = Champion.read(run);
        MsPacManTaskSettings settings = PlayerSettings.of(champion, Optional.empty(), Rules.TRAINING, Optional.empty());
        try (ChampionEvaluator evaluator = new ChampionEvaluator(Rules.TRAINING, 50, 11, 1)) {
            evaluator.evaluate(List.of(new ChampionEvaluator.Entry(champion, settings)));
            assertThat(evaluator.played()).isEqualTo(30);
        }
        assertThat(table()).isEqualTo(whole);
    }

    @Test
    void anotherChampion_isNotMixedWithTheOldOnesGames() throws Exception {
        evaluate(Rules.TRAINING, 20, 1);
        String old = table();
        Files.writeString(
                run.resolve("champion.json"),
                GenotypeJson.write(new InitialNetworks(30, ModuleLayout.withPreferenceNeurons(2, 1))
                        .create(7, new ResumableRandom(6))));
        evaluate(Rules.TRAINING, 20, 1);
        assertThat(table().lines().skip(1).toList())
                .isNotEqualTo(old.lines().skip(2).toList());
    }

    @Test
    void otherGhostLocations_areNotMixedWithTheOldOnesGames() throws Exception {
        Files.writeString(run.resolve("parameters.properties"), "task=isolated\nmethod=2M\nrunNumber=0\n");
        Files.writeString(
                run.resolve("champion.json"),
                GenotypeJson.write(new InitialNetworks(26, ModuleLayout.withPreferenceNeurons(2, 1))
                        .create(7, new ResumableRandom(5))));
        List<String> lines =
                new ArrayList<>(GhostLocations.shippedText().lines().toList());
        Collections.reverse(lines);
        GhostLocations reversed = GhostLocations.read("reversed", new StringReader(String.join("\n", lines)));

        List<String> shippedGames = isolatedGames(GhostLocations.shipped());
        List<String> reversedGames = isolatedGames(reversed);

        assertThat(reversedGames).hasSameSizeAs(shippedGames).isNotEqualTo(shippedGames);
        assertThat(isolatedGames(GhostLocations.shipped())).isEqualTo(shippedGames);
    }

    private List<String> isolatedGames(GhostLocations locations) throws Exception {
        MsPacManTaskSettings settings = MsPacManTaskSettings.isolated(locations);
        try (ChampionEvaluator evaluator = new ChampionEvaluator(Rules.TRAINING, 3, 11, 1)) {
            evaluator.evaluate(List.of(new ChampionEvaluator.Entry(Champion.read(run), settings)));
        }
        // The last column names the locations, so it always differs.
        return table().lines()
                .skip(1)
                .map(line -> line.replaceFirst(",[^,]*$", ""))
                .toList();
    }

    @Test
    void fewerGamesThanThereAre_loseNone() throws Exception {
        evaluate(Rules.TRAINING, 20, 1);
        String all = table();
        ChampionEvaluation again = evaluate(Rules.TRAINING, 5, 1);
        assertThat(again.games()).isEqualTo(20);
        assertThat(table()).isEqualTo(all);
    }

    @Test
    void summary_agreesWithTheGames_andAGameWithItsSeed() throws Exception {
        ChampionEvaluation summary = evaluate(Rules.TRAINING, 20, 1);
        List<GameResult> games = EvaluationTable.read(run.resolve("evaluation-training.csv"))
                .orElseThrow()
                .games();
        assertThat(summary.games()).isEqualTo(20);
        assertThat(summary.meanScore())
                .isEqualTo(
                        games.stream().mapToDouble(GameResult::score).average().orElseThrow());
        assertThat(summary.low()).isLessThan(summary.meanScore());
        assertThat(summary.high()).isGreaterThan(summary.meanScore());
        assertThat(java.util.Arrays.stream(summary.deathsByMaze()).sum()).isBetween(1L, 20L);
        long steps = games.stream().mapToLong(GameResult::steps).sum();
        assertThat(java.util.Arrays.stream(summary.moduleUse().get(0)).sum()).isBetween(steps - 20, steps);
        GameResult game = games.get(13);
        MsPacManTask task = new MsPacManTask(MsPacManTaskSettings.blended().withTrials(1));
        Evaluation again = task.evaluate(Champion.read(run).genotype(), new ResumableRandom(game.seed()));
        assertThat(again.otherScores()[0]).isEqualTo(game.score());
    }

    @Test
    void fourMazeRules_giveThreeLives_andTheirOwnFiles() throws Exception {
        ChampionEvaluation training = evaluate(Rules.TRAINING, 20, 1);
        ChampionEvaluation fourMaze = evaluate(Rules.FOUR_MAZE, 20, 1);
        evaluate(Rules.MPM_VS_GHOSTS, 20, 1);
        assertThat(fourMaze.meanScore()).isGreaterThan(training.meanScore());
        assertThat(run.resolve("evaluation-FourMaze.json")).exists();
        assertThat(run.resolve("evaluation-MPMvsG.csv")).exists();
    }

    @Test
    void networkOfAnotherVersion_isAnErrorWithAdvice() {
        Champion champion = Champion.read(run);
        assertThatThrownBy(() -> PlayerSettings.of(
                        champion, Optional.of(TaskVersion.INTERLEAVED), Rules.TRAINING, Optional.empty()))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("30 inputs")
                .hasMessageContaining("task=");
    }

    @Test
    void missingChampion_isAnError() {
        assertThatThrownBy(() -> Champion.read(base))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("champion.json");
        assertThatThrownBy(() -> Champion.read(base.resolve("none.xml")))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("none.xml");
    }
}
