package mmneat.mspacman;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import mmneat.evolution.Evaluation;
import mmneat.mspacman.ModuleUse.When;
import mmneat.mspacman.modules.AnyGhostEdible;
import mmneat.mspacman.sensors.SensorSettings;
import mmneat.mspacman.sensors.suite.SensorSuite;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.neat.network.ModuleArbitration;
import mmneat.neat.variation.InitialNetworks;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GameRules;
import pacman.game.GameSwitch;
import pacman.game.GhostLocations;

class MsPacManTaskTest {

    private static final ModuleLayout TWO_MODULES = new ModuleLayout(4, 2, 1, false);
    private static final ModuleLayout MULTITASK = new ModuleLayout(2, 2, 1, true);

    private static Genotype network(int inputs, ModuleLayout layout) {
        return new InitialNetworks(inputs, layout).create(1, new ResumableRandom(7));
    }

    private static MsPacManTask blended(int trials) {
        return new MsPacManTask(MsPacManTaskSettings.blended().withTrials(trials));
    }

    @Test
    void names_equalTheOriginals_inTheirOrder() {
        MsPacManTask task = blended(1);

        assertThat(task.objectiveNames()).containsExactly("GhostRewardScore", "PillScore");
        assertThat(task.otherScoreNames()).hasSize(26).startsWith("GameScore", "GameScore", "PillScore");
        assertThat(task.otherScoreLabels())
                .contains("GameScore[Max]", "LevelScore[Mode]")
                .endsWith("EdibleTimeParameter", "LairTimeParameter");
        assertThat(task.inputs()).isEqualTo(30);
        assertThat(task.policyNeuronsPerModule()).isEqualTo(1);
    }

    @Test
    void evaluation_isTheSame_withTheSameSeed_andWithAnObserver() {
        Genotype network = network(30, TWO_MODULES);
        Evaluation first = blended(3).evaluate(network, new ResumableRandom(5));

        MsPacManTask task = blended(3);
        task.evaluate(network, new ResumableRandom(6));
        assertThat(task.evaluate(network, new ResumableRandom(5))).isEqualTo(first);
        assertThat(task.evaluate(network, new ResumableRandom(5), new EvaluationObserver() {}))
                .isEqualTo(first);
    }

    /** Source: docs/specification/mspacman-task.md, section 2. */
    @Test
    void deterministicGames_areSeededByTheirTrial_withAnyGenerator() {
        MsPacManTask task = new MsPacManTask(MsPacManTaskSettings.blended()
                .withGames(games -> games.withTrials(2).withDeterministic(true)));
        Genotype network = network(30, TWO_MODULES);

        assertThat(task.evaluate(network, new ResumableRandom(6)))
                .isEqualTo(task.evaluate(network, new ResumableRandom(5)));
    }

    /** Recorded with this program when it passed all of the original's evaluations. */
    @Test
    void evaluation_givesTheRecordedScores() {
        Genotype network = new InitialNetworks(30, TWO_MODULES).create(1, new ResumableRandom(177));
        ResumableRandom random = new ResumableRandom(5);

        Evaluation evaluation = blended(3).evaluate(network, random);

        assertThat(evaluation.objectives()).containsExactly(2.3333333333333335, 149.0);
        assertThat(evaluation.otherScores())
                .startsWith(
                        2090.0, 2490.0, 149.0, 157.0, 0.125, 0.125, 2.3333333333333335, 4.0, 0.0, 0.0, 0.0, 2.0, 3.0)
                .contains(-11.333333333333334, -11726.666666666666, -1.3333333333333333, -31073.333333333332, -30992.0)
                .endsWith(2090.0, 0.0, 0.0, 0.0, 200.0, 40.0);
        assertThat(evaluation.moduleUsage()).containsExactly(545, 0);
        assertThat(evaluation.outcomes()).isEqualTo(new Evaluation.Outcomes(0, 0, 3, 2780));
        assertThat(random.nextLong()).isEqualTo(-5565103765288366194L);
    }

    @Test
    void observer_isToldOfEveryTrialGameAndStep() {
        List<String> events = new ArrayList<>();
        int[] steps = new int[1];
        int[] decisions = new int[1];
        Evaluation evaluation = blended(2)
                .evaluate(network(30, TWO_MODULES), new ResumableRandom(5), new EvaluationObserver() {
                    @Override
                    public void trialStarted(int trial) {
                        events.add("trial " + trial);
                    }

                    @Override
                    public void stepPlayed(Game game, DirectionEvaluator player) {
                        steps[0]++;
                    }

                    @Override
                    public void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {
                        events.add(end.toString());
                        decisions[0] += player.moduleUse().decisions();
                    }

                    @Override
                    public void trialOver(int trial, double[] objectives, double[] otherScores) {
                        events.add("over " + trial);
                    }
                });

        assertThat(events)
                .containsExactly("trial 0", "LOST_ALL_LIVES", "over 0", "trial 1", "LOST_ALL_LIVES", "over 1");
        assertThat(evaluation.outcomes().steps()).isEqualTo(steps[0]).isEqualTo(decisions[0]);
        assertThat(evaluation.outcomes().failed()).isEqualTo(2);
    }

    @Test
    void moduleUse_isCountedByObservation_andAddsUp() {
        ModuleUse total = new ModuleUse(2);
        blended(5).evaluate(network(30, TWO_MODULES), new ResumableRandom(5), new EvaluationObserver() {
            @Override
            public void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {
                total.add(player.moduleUse());
            }
        });

        for (int module = 0; module < 2; module++) {
            assertThat(total.ofChosenDirection(When.ALL)[module])
                    .isEqualTo(total.ofChosenDirection(When.EDIBLE)[module]
                            + total.ofChosenDirection(When.THREAT)[module]);
            assertThat(total.ofChosenDirection(When.AT_JUNCTION)[module])
                    .isEqualTo(total.ofChosenDirection(When.EDIBLE_AT_JUNCTION)[module]
                            + total.ofChosenDirection(When.THREAT_AT_JUNCTION)[module]);
        }
        int[] all = total.ofChosenDirection(When.ALL);
        assertThat(all[0] + all[1]).isEqualTo(total.decisions()).isPositive();
        int[] left = total.ofNetwork(MOVE.LEFT.ordinal(), When.ALL);
        assertThat(left[0] + left[1]).isBetween(1, total.decisions());
    }

    @Test
    void network_thatDoesNotSuitTheTask_isRefusedWithAReason() {
        assertThatThrownBy(() -> blended(1).evaluate(network(26, TWO_MODULES), new ResumableRandom(1)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("the network has 26 inputs, but there are 30 sensors");
        assertThatThrownBy(() -> blended(1).evaluate(network(30, MULTITASK), new ResumableRandom(1)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("needs a division of the task");
    }

    @Test
    void isolatedVersion_withoutGhostLocations_isRefused() {
        assertThatThrownBy(() -> new GameSettings(
                        TaskVersion.ISOLATED,
                        1,
                        GameRules.interleaved(),
                        pacman.controllers.examples.Legacy::new,
                        false))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("mazePowerPillGhostMapping");
    }

    @Test
    void isolatedTrial_isAPillGameAndFourGhostGames_andNeedsGhostLocations() {
        GameRules rules = GameRules.interleaved();
        List<TrialGame> blended = TrialGame.of(TaskVersion.BLENDED, rules);
        assertThat(blended).extracting(TrialGame::rules).containsExactly(rules);
        List<TrialGame> isolated =
                MsPacManTaskSettings.isolated(GhostLocations.shipped()).games().ofTrial();
        assertThat(isolated).extracting(TrialGame::countsGhosts).containsExactly(false, true, true, true, true);
        assertThat(isolated.get(0).rules().switches()).contains(GameSwitch.WITHOUT_POWER_PILLS);
        assertThat(isolated.subList(1, 5))
                .extracting(game -> game.rules().mazes().startingPowerPill())
                .containsExactly(0, 1, 2, 3);
        Set<GameSwitch> expected = EnumSet.of(GameSwitch.IMPRISONED_WHILE_EDIBLE);
        expected.addAll(GameSwitch.GHOST_TASK);
        assertThat(isolated.subList(1, 5))
                .extracting(game -> game.rules().switches())
                .containsOnly(expected);
        assertThatThrownBy(() -> TrialGame.of(TaskVersion.ISOLATED, rules))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("ghostLocations");
    }

    @Test
    void ghostGames_haveTheRulesOfAllGhostsAndPills_butNoOtherSwitchOfAFullGame() {
        GameRules all = MsPacManTaskSettings.isolated(GhostLocations.shipped())
                .games()
                .rules()
                .withSwitches(EnumSet.allOf(GameSwitch.class));
        List<TrialGame> games = TrialGame.of(TaskVersion.ISOLATED, all);

        assertThat(games.get(0).rules().switches()).isEqualTo(EnumSet.allOf(GameSwitch.class));
        Set<GameSwitch> expected = EnumSet.of(
                GameSwitch.INFINITE_EDIBLE_TIME,
                GameSwitch.IMPRISONED_WHILE_EDIBLE,
                GameSwitch.WITHOUT_RANDOM_REVERSALS,
                GameSwitch.DIE_ON_IMPROPER_POWER_PILL_EATING);
        expected.addAll(GameSwitch.GHOST_TASK);
        assertThat(games.subList(1, 5))
                .extracting(game -> game.rules().switches())
                .containsOnly(expected);
    }

    @Test
    void playerOfAFile_playsUnderAnyRules_andEndsGamesByTheirRules() {
        NetworkPacMan player = NetworkPacMan.published(network(30, TWO_MODULES), null, 1);
        Game game = new Game(3, GameRules.competition());
        for (int step = 0; step < 300 && !game.gameOver(); step++) {
            MOVE move = player.getMove(game.copy(), -1);
            assertThat(move).isNotNull();
            game.advanceGame(move, null);
        }
        assertThat(game.getTotalTime()).isPositive();
        assertThat(NetworkPacMan.published(network(26, MULTITASK), null, 1)
                        .getMove(new Game(3, GameRules.interleaved()), -1))
                .isNotNull();
        assertThatThrownBy(() -> NetworkPacMan.published(network(7, TWO_MODULES), null, 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("7 inputs");
    }

    @Test
    void multitaskPlayer_usesTheModuleOfTheDivision_inAllDirections() {
        DirectionEvaluator player = new DirectionEvaluator(
                SensorSuite.of(SensorSettings.imprisoned()).newInputs(),
                network(26, MULTITASK),
                ModuleArbitration.PREFERENCE,
                new AnyGhostEdible());
        player.decide(new Game(3, GameRules.interleaved()), new ResumableRandom(1));

        assertThat(player.moduleUse().ofChosenDirection(When.ALL)).containsExactly(1, 0);
        assertThat(player.moduleUse().ofChosenDirection(When.THREAT)).containsExactly(1, 0);
    }
}
