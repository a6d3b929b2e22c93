package pacman.game;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.function.LongFunction;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.maze.MazeTables;
import pacman.maze.Mazes;

/** Games by the rules of both frameworks: copies, restarts, state strings and levels. */
class GameTest {

    private static final MOVE[] MOVES = MOVE.values();

    private static final String DRAWING_WITHOUT_POWER_PILLS = """
            ############################
            #............G.............#
            #.##########.##.##########.#
            #.##########.##.##########.#
            #............P.............#
            #############L##############
            """ + "############################\n".repeat(23);

    /** Plays a random step: moves of all kinds, and ghosts that chase Ms. Pac-Man. */
    private static void play(Game game, ResumableRandom random) {
        EnumMap<GHOST, MOVE> ghosts = new EnumMap<>(GHOST.class);
        for (GHOST ghost : GHOST.values()) {
            if (game.doesGhostRequireAction(ghost)) {
                ghosts.put(
                        ghost,
                        game.getApproximateNextMoveTowardsTarget(
                                game.getGhostCurrentNodeIndex(ghost),
                                game.getPacmanCurrentNodeIndex(),
                                game.getGhostLastMoveMade(ghost),
                                DM.PATH));
            }
        }
        game.advanceGame(MOVES[random.nextInt(5)], ghosts);
    }

    private static String played(LongFunction<Game> newGame, long seed) {
        Game game = newGame.apply(seed);
        ResumableRandom random = new ResumableRandom(seed);
        while (!game.gameOver()) {
            play(game, random);
        }
        return game.getGameState() + game.rnd.bits();
    }

    @Test
    void competitionGame_isReproducible_andIndependentOfOtherThreads() {
        List<String> alone = LongStream.range(0, 40)
                .mapToObj(seed -> played(Game::new, seed))
                .toList();
        List<String> together = LongStream.range(0, 40)
                .parallel()
                .mapToObj(seed -> played(Game::new, seed))
                .toList();
        assertThat(together).isEqualTo(alone);
        assertThat(alone).doesNotHaveDuplicates();
    }

    @Test
    void competitionCopyThatContinues_equalsTheGame_includingFlags() {
        ResumableRandom random = new ResumableRandom(5);
        int flagsSeen = 0;
        GameRules rules = GameRules.competition().withCopies(GameRules.Copies.CONTINUE_THE_GAME);
        for (long seed = 0; seed < 20; seed++) {
            Game game = new Game(seed, rules);
            while (!game.gameOver()) {
                Game copy = game.copy();
                assertThat(copy.getGameState()).isEqualTo(game.getGameState());
                assertThat(copy.rnd.bits()).isEqualTo(game.rnd.bits());
                flagsSeen += copy.wasPillEaten() ? 1 : 0;
                ResumableRandom same = random.copy();
                play(game, random);
                play(copy, same);
                assertThat(copy.getGameState()).isEqualTo(game.getGameState());
                assertThat(copy.getGhostCurrentEdibleScore()).isEqualTo(game.getGhostCurrentEdibleScore());
            }
        }
        assertThat(flagsSeen).isPositive();
    }

    @Test
    void competitionCopy_continuesTheSwitches() {
        GameRules rules = GameRules.competition().with(GameSwitch.PILL_TASK);
        Game copy = new Game(1, rules).copy();
        Game next = copy.copy();
        while (next.getCurrentLevel() == 0 && next.getCurrentLevelTime() < Constants.LEVEL_LIMIT) {
            next.updateGame(false, false, false, true, true);
        }
        assertThat(next.getCurrentLevel()).isEqualTo(1);
        assertThat(next.getNumberOfActivePills()).isEqualTo(194);
        assertThat(next.getNumberOfActivePowerPills()).isZero();
    }

    @Test
    void mmneatCopy_losesTheRecordOfWhatWasEaten() {
        Game game = new Game(0, GameRules.mmneat());
        while (!game.wasPillEaten()) {
            game.advanceGame(MOVE.LEFT, null);
        }
        assertThat(game.copy().wasPillEaten()).isFalse();
    }

    @Test
    void changingACopy_doesNotChangeTheGame() {
        Game game = new Game(3, GameRules.blended());
        ResumableRandom random = new ResumableRandom(3);
        for (int step = 0; step < 150 && !game.gameOver(); step++) {
            String before = game.getGameState();
            Game copy = game.copy();
            for (int ahead = 0; ahead < 10 && !copy.gameOver(); ahead++) {
                play(copy, random);
            }
            copy.playWithoutPills();
            assertThat(game.getGameState()).isEqualTo(before);
            play(game, random);
        }
    }

    @Test
    void nullMove_endsTheGameFromTheTwelfthCallOn_inMmneatOnly() {
        Game mmneat = new Game(0, GameRules.mmneat());
        Game competition = new Game(0);
        for (int call = 1; call <= 11; call++) {
            mmneat.advanceGame(null, null);
            competition.advanceGame(null, null);
        }
        assertThat(mmneat.gameOver()).isFalse();
        mmneat.advanceGame(null, null);
        competition.advanceGame(null, null);
        assertThat(mmneat.gameOver()).isTrue();
        assertThat(mmneat.getTotalTime()).isEqualTo(11);
        assertThat(competition.gameOver()).isFalse();
        assertThat(competition.getTotalTime()).isEqualTo(12);
    }

    @Test
    void competitionLevel_endsAfterFourThousandSteps_andTheGameAfterTwentyFourThousand() {
        GameRules rules = GameRules.competition().withGhosts(ghosts -> ghosts.withActiveGhosts(0));
        Game game = new Game(0, rules);
        for (int step = 0; step < 3999; step++) {
            game.advanceGame(MOVE.NEUTRAL, null);
        }
        assertThat(game.getCurrentLevel()).isZero();
        game.advanceGame(MOVE.NEUTRAL, null);
        assertThat(game.getCurrentLevel()).isEqualTo(1);
        assertThat(game.getMazeIndex()).isEqualTo(1);
        assertThat(game.getCurrentLevelTime()).isZero();
        int score = 0;
        while (!game.gameOver()) {
            score = game.getScore();
            game.advanceGame(MOVE.NEUTRAL, null);
        }
        assertThat(game.getTotalTime()).isEqualTo(Constants.MAX_TIME);
        assertThat(game.getScore()).isEqualTo(score + 3 * Constants.AWARD_LIFE_LEFT);
        // The step that ends the game does not check the end of the level.
        assertThat(game.getCurrentLevel()).isEqualTo(5);
    }

    @Test
    void restart_isANewGame() {
        for (GameRules rules : List.of(GameRules.competition(), GameRules.interleaved(), GameRules.isolatedPills())) {
            Game restarted = new Game(77, rules);
            ResumableRandom random = new ResumableRandom(7);
            for (int step = 0; step < 500 && !restarted.gameOver(); step++) {
                play(restarted, random);
            }
            restarted.restart(5);
            Game fresh = new Game(5, rules);
            ResumableRandom same = random.copy();
            while (!fresh.gameOver() && fresh.getTotalTime() < 2000) {
                assertThat(restarted.getGameState()).isEqualTo(fresh.getGameState());
                play(fresh, random);
                play(restarted, same);
            }
            assertThat(restarted.getPillEatTimes()).isEqualTo(fresh.getPillEatTimes());
            assertThat(restarted.getScore(0)).isEqualTo(fresh.getScore(0));
        }
    }

    @Test
    void restoredGame_continuesLikeTheGame_untilAGhostIsWorthMore() {
        ResumableRandom random = new ResumableRandom(9);
        for (long seed = 0; seed < 30; seed++) {
            Game game = new Game(seed, GameRules.blended(), new ResumableRandom(seed));
            while (!game.gameOver()) {
                Game restored = new Game(0, GameRules.blended(), new ResumableRandom(0));
                restored.setGameState(game.getGameState());
                boolean comparable = game.getGhostCurrentEdibleScore() == Constants.GHOST_EAT_SCORE;
                ResumableRandom same = random.copy();
                play(game, random);
                play(restored, same);
                if (comparable && !restored.gameOver()) {
                    assertThat(restored.getGameState()).isEqualTo(game.getGameState());
                }
            }
        }
    }

    @Test
    void state_atTheStart_isTheSpecifications() {
        String expected =
                "25214903917,0,0,0,0,-12800.0,0,0,0,0,0,0,0,0,0,0,false,false,false,false,0,0,0,0,0,0,978,LEFT,1,false,"
                        + "1292,0,40,NEUTRAL,1292,0,60,NEUTRAL,1292,0,80,NEUTRAL,1292,0,100,NEUTRAL," + "1".repeat(220)
                        + ",1111,-1,false,false,false,false,false,false,false";
        assertThat(new Game(0, GameRules.mmneat()).getGameState()).isEqualTo(expected);
        String competition = new Game(0).getGameState();
        assertThat(competition.split(",")).hasSize(35);
        assertThat(competition).startsWith("0,0,0,0,0,978,LEFT,3,false,1292,0,40,NEUTRAL,");
    }

    @Test
    void state_ofEitherForm_isRead() {
        Game game = new Game(4);
        ResumableRandom random = new ResumableRandom(4);
        for (int step = 0; step < 100; step++) {
            play(game, random);
        }
        Game mmneat = new Game(0, GameRules.mmneat());
        mmneat.setGameState(game.getGameState());
        assertThat(mmneat.getPacmanCurrentNodeIndex()).isEqualTo(game.getPacmanCurrentNodeIndex());
        Game back = new Game(0);
        back.setGameState(mmneat.getGameState());
        assertThat(back.getGameState()).isEqualTo(game.getGameState());
    }

    @Test
    void badState_isRefused_withWhatIsWrong() {
        Game game = new Game(0);
        String good = game.getGameState();
        assertThatThrownBy(() -> game.setGameState("1,2,3"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("this one has 3");
        assertThatThrownBy(() -> game.setGameState(good.replace("LEFT", "WEST")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("WEST");
        assertThatThrownBy(() -> game.setGameState(good.replace("1".repeat(220), "1".repeat(219))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("the maze has 220 pills");
        assertThatThrownBy(() -> game.setGameState(good.replace("978,LEFT", "1293,LEFT")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("1293");
        assertThatThrownBy(() -> game.setGameState("4" + good.substring(1)))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void refusedState_changesNothing() {
        for (GameRules rules : List.of(GameRules.competition(), GameRules.interleaved())) {
            Game game = new Game(3, rules);
            ResumableRandom random = new ResumableRandom(3);
            for (int step = 0; step < 300; step++) {
                play(game, random);
            }
            String before = game.getGameState();
            String[] fields = new Game(9, rules).getGameState().split(",");
            int mazeField = fields.length == 35 ? 0 : 20;
            fields[mazeField] = "1";
            assertThatThrownBy(() -> game.setGameState(String.join(",", fields)))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("the maze has 240 pills");
            assertThat(game.getGameState()).isEqualTo(before);
        }
    }

    @Test
    void distanceQueries_refuseInvalidNodes() {
        Game game = new Game(0);
        int nodes = game.getNumberOfNodes();
        int junction = game.getJunctionIndices()[0];
        for (int node : new int[] {nodes, nodes + 5, 2 * nodes, -2, -5}) {
            assertThatThrownBy(() -> game.getShortestPathDistance(node, 5))
                    .isInstanceOf(ArrayIndexOutOfBoundsException.class);
            assertThatThrownBy(() -> game.getShortestPathDistance(5, node))
                    .isInstanceOf(ArrayIndexOutOfBoundsException.class);
            assertThatThrownBy(() -> game.getShortestPathDistance(junction, node, MOVE.NEUTRAL))
                    .isInstanceOf(ArrayIndexOutOfBoundsException.class);
            assertThatThrownBy(() -> game.getClosestNodeIndexFromNodeIndex(node, new int[] {5, 6}, DM.PATH))
                    .isInstanceOf(ArrayIndexOutOfBoundsException.class);
        }
        assertThatThrownBy(() -> game.getShortestPathDistance(junction, -1, MOVE.NEUTRAL))
                .isInstanceOf(ArrayIndexOutOfBoundsException.class);
        assertThat(game.getShortestPathDistance(5, -1))
                .as("the original's quirk")
                .isZero();
    }

    @Test
    void restart_givesTheChanceOfAnExtraLifeAgain() {
        Game game = new Game(3);
        List<String> fields = new ArrayList<>(List.of(game.getGameState().split(",")));
        int lives = fields.indexOf(MOVE.LEFT.name()) + 1;
        assertThat(fields.get(lives)).isEqualTo("3");
        fields.set(lives + 1, "true");
        game.setGameState(String.join(",", fields));
        game.restart(3);
        assertThat(game.getGameState()).isEqualTo(new Game(3).getGameState());
    }

    @Test
    void explicitNullForAGhost_staysNull_whileAMissingOneBecomesNeutral() {
        Game game = new Game(3);
        EnumMap<GHOST, MOVE> moves = new EnumMap<>(GHOST.class);
        moves.put(GHOST.SUE, null);
        game.advanceGame(MOVE.LEFT, moves);
        assertThat(moves).containsEntry(GHOST.SUE, null).containsEntry(GHOST.INKY, MOVE.NEUTRAL);
    }

    @Test
    void finishedGame_givesAStateThatCanBeReadAgain() {
        GameRules rules = GameRules.blended()
                .withLevels(levels -> levels.withLevelTimeLimit(50).withFatalTimeLimit(false));
        for (int onlyMaze : new int[] {-1, 0, 1, 2, 3}) {
            GameRules here = rules.withMazes(mazes -> mazes.withOnlyMaze(onlyMaze));
            Game game = new Game(1, here, new ResumableRandom(1));
            while (!game.gameOver()) {
                game.advanceGame(MOVE.LEFT, null);
            }
            assertThat(game.getCurrentLevel()).isEqualTo(4);
            Game again = new Game(0, here, new ResumableRandom(0));
            again.setGameState(game.getGameState());
            assertThat(again.getGameState()).isEqualTo(game.getGameState());
        }
    }

    @Test
    void path_fromANodeToItself_isEmpty_whateverTheLastMove() {
        Game game = new Game(0);
        assertThat(game.getShortestPath(5, 5, null)).isEmpty();
        assertThat(game.getShortestPathDistance(5, 5, null)).isZero();
        assertThat(Game.caches[0].getPathFromA2B(5, 5, null)).isEmpty();
        assertThatThrownBy(() -> game.getShortestPath(5, 6, null)).isInstanceOf(NullPointerException.class);
        int junction = game.getJunctionIndices()[0];
        assertThat(Game.caches[0].getPathFromA2B(junction, 5, null)).isEqualTo(game.getShortestPath(junction, 5, null));
    }

    @Test
    void levelScore_ofALevelThatWasNotReached_isRefused() {
        Game game = new Game(0);
        assertThat(game.getScore(0)).isZero();
        assertThatThrownBy(() -> game.getScore(2)).isInstanceOf(IndexOutOfBoundsException.class);
    }

    @Test
    void restart_ofAGameThatStartedInAnotherMaze_startsThereAgain() {
        Game game = new Game(0, 2);
        game.restart(1);
        assertThat(game.getGameState()).isEqualTo(new Game(1, 2).getGameState());
        assertThatThrownBy(() -> new Game(0, 4)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void powerPillsBehindTheLastLevel_areThoseThatTheNextMazeHasToo() {
        MazeTables first = Mazes.standard().get(0);
        MazeTables none = MazeTables.parse("none", DRAWING_WITHOUT_POWER_PILLS);
        GameRules rules = GameRules.mmneat()
                .withMazes(mazes -> mazes.withMazes(Mazes.of(List.of(first, none))))
                .withLevels(levels ->
                        levels.withMaximumLevel(1).withLevelTimeLimit(20).withFatalTimeLimit(false));
        Game game = new Game(0, rules);
        while (!game.gameOver()) {
            game.advanceGame(MOVE.LEFT, null);
        }
        assertThat(game.getNumberOfActivePowerPills()).isEqualTo(4);
        assertThat(game.getActivePowerPillsIndices()).isEmpty();
    }

    /** Edible time, lair time and first lair times by level; docs/specification/simulator.md, section 2.1. */
    @ParameterizedTest
    @CsvSource({
        "0, 200, 40, 60, 80, 100",
        "1, 179, 35, 53, 71, 89",
        "2, 161, 32, 48, 64, 80",
        "3, 145, 29, 43, 58, 72",
        "4, 131, 26, 39, 52, 65",
        "5, 118, 23, 35, 47, 59",
        "6, 200, 40, 60, 80, 100"
    })
    void times_shrinkFromLevelToLevel(int level, int edible, int blinky, int pinky, int inky, int sue) {
        Game game = new Game(0);
        while (game.getCurrentLevel() < level) {
            game.updateGame(false, false, false, false, true);
        }
        assertThat(game.newEdibleTime()).isEqualTo(edible);
        assertThat(IntStream.range(0, 4).map(game::ghostLairTime)).containsExactly(blinky, pinky, inky, sue);
    }

    @Test
    void queriesWithNodeMinusOne_areThoseOfTheFrameworks() {
        int[] targets = {-1, 500};
        assertThat(new Game(0, GameRules.mmneat()).getClosestNodeIndexFromNodeIndex(100, targets, DM.PATH))
                .isEqualTo(500);
        assertThat(new Game(0).getClosestNodeIndexFromNodeIndex(100, targets, DM.PATH))
                .isEqualTo(-1);
        assertThat(new Game(0).getShortestPathDistance(100, -1)).isZero();
        assertThatThrownBy(() -> new Game(0).getShortestPathDistance(0, -1))
                .isInstanceOf(IndexOutOfBoundsException.class);
    }

    @Test
    void edgeCasesOfQueries_areTheSpecifications() {
        Game game = new Game(0);
        int lair = game.getNumberOfNodes() - 1;
        assertThat(game.getPossibleMoves(lair)).isEmpty();
        assertThat(game.getPossibleMoves(lair, MOVE.UP)).isNull();
        assertThat(game.getPossibleMoves(0, null)).isNull();
        assertThat(game.getNeighbour(0, null)).isEqualTo(-1);
        assertThat(game.getNeighbour(0, MOVE.NEUTRAL)).isEqualTo(-1);
        assertThat(game.getMoveToMakeToReachDirectNeighbour(0, 700)).isNull();
        assertThat(game.getNextMoveTowardsTarget(lair, 0, DM.PATH)).isNull();
        assertThat(game.isPillStillAvailable(1000)).isFalse();
        assertThatThrownBy(() -> game.isPillStillAvailable(-1)).isInstanceOf(IndexOutOfBoundsException.class);
        assertThatThrownBy(() -> game.getShortestPath(1, 500, null)).isInstanceOf(NullPointerException.class);
        assertThatThrownBy(() -> game.getNextMoveTowardsTarget(lair, 0, MOVE.UP, DM.PATH))
                .isInstanceOf(NullPointerException.class);
        assertThatThrownBy(() -> game.copy().getScore(0)).isInstanceOf(IllegalStateException.class);
        assertThat(game.copy().getPillEatTimes()).isNull();
    }

    @Test
    void callersMap_holdsTheMovesMade() {
        Game game = new Game(0);
        for (int step = 0; step < 40; step++) {
            game.advanceGame(MOVE.NEUTRAL, null);
        }
        EnumMap<GHOST, MOVE> moves = new EnumMap<>(GHOST.class);
        moves.put(GHOST.BLINKY, MOVE.RIGHT);
        game.advanceGame(MOVE.NEUTRAL, moves);
        assertThat(moves)
                .containsEntry(GHOST.BLINKY, game.getGhostLastMoveMade(GHOST.BLINKY))
                .containsEntry(GHOST.PINKY, MOVE.NEUTRAL)
                .hasSize(4);
    }

    @Test
    void stepWithoutMap_isTheStepWithOne() {
        Game withMap = new Game(8, GameRules.blended());
        Game without = new Game(8, GameRules.blended());
        ResumableRandom random = new ResumableRandom(8);
        while (!withMap.gameOver()) {
            EnumMap<GHOST, MOVE> moves = new EnumMap<>(GHOST.class);
            int packed = GhostMoves.NONE;
            for (GHOST ghost : GHOST.values()) {
                if (random.nextInt(3) == 0) {
                    MOVE move = MOVES[random.nextInt(5)];
                    moves.put(ghost, move);
                    packed = GhostMoves.with(packed, ghost, move);
                    assertThat(GhostMoves.get(packed, ghost)).isEqualTo(move);
                }
            }
            MOVE pacMan = MOVES[random.nextInt(5)];
            without.advanceGame(pacMan, packed);
            withMap.advanceGame(pacMan, moves);
            assertThat(without.getGameState()).isEqualTo(withMap.getGameState());
        }
    }
}
