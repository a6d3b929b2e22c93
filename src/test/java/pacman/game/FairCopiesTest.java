package pacman.game;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import pacman.Executor;
import pacman.controllers.Controller;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.StarterPacMan;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.GameRules.Copies;

/** Under competition rules a copy of the game shows a possible future, not the real one. */
class FairCopiesTest {

    private static final GameRules FAIR = GameRules.competition();
    private static final GameRules CONTINUING = FAIR.withCopies(Copies.CONTINUE_THE_GAME);

    @Test
    void competitionPresets_haveIndependentCopies_andTheOthersContinue() {
        assertThat(List.of(GameRules.competition(), GameRules.mpmVsGhosts()))
                .extracting(GameRules::copies)
                .containsOnly(Copies.ARE_INDEPENDENT);
        assertThat(List.of(
                        GameRules.mmneat(),
                        GameRules.blended(),
                        GameRules.interleaved(),
                        GameRules.isolatedPills(),
                        GameRules.fourMaze()))
                .extracting(GameRules::copies)
                .containsOnly(Copies.CONTINUE_THE_GAME);
        assertThat(new Game(0).rules().copies()).isEqualTo(Copies.ARE_INDEPENDENT);
    }

    /** Counts of a predictor's correct predictions in one or more games. */
    private static final class Record {
        int sueAtJunctions;
        int sueForeseen;
        int reversals;
        int reversalsForeseen;
        int reversalsPredicted;
    }

    /**
     * Simulates the next step with Legacy in a copy, and compares the last prediction with the actual step.
     *
     * <p>The player moves like StarterPacMan; {@code prepare} may change the copy before it is used.
     */
    private static final class Predictor extends Controller<MOVE> {
        private final StarterPacMan player = new StarterPacMan();
        private final Legacy legacy = new Legacy();
        private final Consumer<Game> prepare;
        private final Record record;
        private Game predicted;
        private Game before;

        Predictor(Consumer<Game> prepare, Record record) {
            this.prepare = prepare;
            this.record = record;
        }

        @Override
        public MOVE getMove(Game game, long timeDue) {
            if (predicted != null) {
                compare(game);
            }
            MOVE move = player.getMove(game, timeDue);
            before = game.copy();
            predicted = game.copy();
            prepare.accept(predicted);
            predicted.advanceGame(move, legacy.getMove(predicted.copy(), timeDue));
            return move;
        }

        private void compare(Game now) {
            boolean reversed = reversed(now);
            if (!now.wasPowerPillEaten() && now.getCurrentLevelTime() > 2) {
                record.reversals += reversed ? 1 : 0;
                record.reversalsPredicted += reversed(predicted) ? 1 : 0;
                record.reversalsForeseen += reversed && reversed(predicted) ? 1 : 0;
            }
            if (before.doesGhostRequireAction(GHOST.SUE) && !reversed && !now.wasPacManEaten()) {
                record.sueAtJunctions++;
                record.sueForeseen +=
                        now.getGhostCurrentNodeIndex(GHOST.SUE) == predicted.getGhostCurrentNodeIndex(GHOST.SUE)
                                ? 1
                                : 0;
            }
        }

        private boolean reversed(Game after) {
            return after.getTimeOfLastGlobalReversal() == before.getTotalTime()
                    && before.getTimeOfLastGlobalReversal() != before.getTotalTime();
        }
    }

    private static Record predict(GameRules rules, Consumer<Game> prepare) {
        Record record = new Record();
        for (long seed = 0; seed < 60; seed++) {
            new Executor().runExperiment(new Predictor(prepare, record), new Legacy(), new Game(seed, rules));
        }
        return record;
    }

    private static double share(int part, int whole) {
        return (double) part / whole;
    }

    @Test
    void predictor_isRightNoMoreOftenThanChance() {
        Record fair = predict(FAIR, copy -> {});
        ResumableRandom unrelated = new ResumableRandom(99);
        Record guessing = predict(FAIR, copy -> copy.rnd.setSeed(unrelated.nextLong()));
        assertThat(fair.sueAtJunctions).isGreaterThan(2000);
        assertThat(fair.reversals).isGreaterThan(100);
        double chance = share(guessing.sueForeseen, guessing.sueAtJunctions);
        double fourDeviations = 4 * Math.sqrt(2 * chance * (1 - chance) / fair.sueAtJunctions);
        assertThat(share(fair.sueForeseen, fair.sueAtJunctions)).isLessThan(chance + fourDeviations);
        // Ghosts reverse in one of 200 steps: predicting more than a few of hundreds of reversals would not be chance.
        assertThat(fair.reversalsForeseen).isLessThan(8);
        assertThat(fair.reversalsPredicted).isGreaterThan(100);
    }

    @Test
    void predictorWithCopiesThatContinue_foreseesNearlyEverything() {
        Record continuing = predict(CONTINUING, copy -> {});
        assertThat(continuing.sueForeseen).isEqualTo(continuing.sueAtJunctions);
        assertThat(continuing.reversalsForeseen).isEqualTo(continuing.reversals);
    }

    /** A controller that tries random futures in copies until it survives one; it throws after very many attempts. */
    private static final class Retrying extends Controller<MOVE> {
        private static final MOVE[] MOVES = MOVE.values();
        private int most;

        @Override
        public MOVE getMove(Game game, long timeDue) {
            for (int tries = 1; tries < 100_000; tries++) {
                Game copy = game.copy();
                MOVE first = MOVES[copy.rnd.nextInt(4)];
                copy.advanceGame(first, new EnumMap<>(GHOST.class));
                for (int step = 0; step < 5 && !copy.wasPacManEaten(); step++) {
                    copy.advanceGame(MOVES[copy.rnd.nextInt(4)], null);
                }
                if (!copy.wasPacManEaten()) {
                    most = Math.max(most, tries);
                    return first;
                }
            }
            throw new IllegalStateException("no future is survived");
        }
    }

    @Test
    void entryThatRetriesUntilItSurvives_ends() {
        Retrying entry = new Retrying();
        Game game = new Game(1);
        while (!game.gameOver()) {
            MOVE move = game.getTotalTime() % 3 == 0 && !cornered(game) ? entry.getMove(game.copy(), -1) : MOVE.LEFT;
            game.advanceGame(move, new Legacy().getMove(game.copy(), -1));
        }
        assertThat(entry.most)
                .as("a copy that repeats the one before never survives")
                .isGreaterThan(1);
    }

    /** Whether a threat is so near that Ms. Pac-Man survives in no future. */
    private static boolean cornered(Game game) {
        for (GHOST ghost : GHOST.values()) {
            if (game.getGhostLairTime(ghost) == 0
                    && !game.isGhostEdible(ghost)
                    && game.getShortestPathDistance(
                                    game.getGhostCurrentNodeIndex(ghost), game.getPacmanCurrentNodeIndex())
                            < 6) {
                return true;
            }
        }
        return false;
    }

    @Test
    void copies_differFromTheGame_fromEachOther_andFromTheirOwnCopies() {
        Set<Long> generators = new HashSet<>();
        int made = 0;
        Game game = new Game(7);
        while (game.getTotalTime() < 500 && !game.gameOver()) {
            Game first = game.copy();
            Game second = game.copy();
            List<Game> all = List.of(game, first, second, first.copy(), first.copy(), second.copy());
            made += all.size();
            all.forEach(each -> generators.add(each.rnd.bits()));
            assertThat(first.getGameState()).isEqualTo(game.getGameState());
            game.advanceGame(MOVE.LEFT, null);
        }
        assertThat(generators).hasSize(made);
    }

    /** Generators of the copies in one game. */
    private static List<Long> generatorsOfCopies(Game game, int views) {
        List<Long> generators = new ArrayList<>();
        for (int step = 0; step < 300; step++) {
            for (int view = 0; view < views; view++) {
                game.snapshot();
            }
            generators.add(game.copy().rnd.bits());
            game.advanceGame(MOVE.LEFT, null);
        }
        generators.add(game.rnd.bits());
        return generators;
    }

    @Test
    void copies_followFromTheSeed_alsoAfterARestart_andWhetherTheGameIsShownOrNot() {
        List<Long> first = generatorsOfCopies(new Game(3), 0);
        assertThat(generatorsOfCopies(new Game(3), 2)).isEqualTo(first);
        assertThat(generatorsOfCopies(new Game(4), 0)).doesNotContainAnyElementsOf(first);
        Game again = new Game(5);
        generatorsOfCopies(again, 0);
        again.restart(3);
        assertThat(generatorsOfCopies(again, 0)).isEqualTo(first);
    }

    @Test
    void exampleThatReadsTheLiveGame_drawsTheNumbersOfACopy() {
        Game copied = new Game(11);
        StarterPacMan player = new StarterPacMan();
        Legacy team = new Legacy();
        while (!copied.gameOver()) {
            copied.advanceGame(player.getMove(copied.copy(), -1), team.getMove(copied.copy(), -1));
        }
        Game live = new Game(11);
        new Executor().runExperiment(new StarterPacMan(), new Legacy(), live);
        assertThat(live.getGameState()).isEqualTo(copied.getGameState());
        assertThat(live.rnd.bits()).isEqualTo(copied.rnd.bits());
    }

    @Test
    void copy_doesNotDrawFromTheGeneratorOfTheRun() {
        GameRules rules = GameRules.mpmVsGhosts();
        ResumableRandom run = new ResumableRandom(1);
        Game game = new Game(0, rules, run);
        long before = run.bits();
        Game copy = game.copy();
        while (!copy.gameOver() && copy.getTotalTime() < 2000) {
            copy.advanceGame(MOVE.RIGHT, new Legacy().getMove(copy, -1));
        }
        assertThat(run.bits()).isEqualTo(before);
    }
}
