package pacman;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.event.KeyEvent;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.JLabel;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import pacman.controllers.Controller;
import pacman.controllers.HumanController;
import pacman.controllers.KeyBoardInput;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.NearestPillPacManVS;
import pacman.controllers.examples.StarterPacMan;
import pacman.game.Constants;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GameRules;
import pacman.game.GhostLocations;

/** The run modes: docs/specification/controllers.md, section 6. */
@Timeout(120)
class ExecutorTest {

    /** A controller that returns null, which ends a game by MM-NEAT's rules in its twelfth tick. */
    private static final class Silent extends Controller<MOVE> {
        @Override
        public MOVE getMove(Game game, long timeDue) {
            return null;
        }
    }

    private static final class Throwing extends Controller<MOVE> {
        @Override
        public MOVE getMove(Game game, long timeDue) {
            throw new IllegalStateException("no idea at " + game.getTotalTime());
        }
    }

    private static final class NoGhosts extends Controller<EnumMap<GHOST, MOVE>> {
        @Override
        public EnumMap<GHOST, MOVE> getMove(Game game, long timeDue) {
            return null;
        }
    }

    @TempDir
    private Path folder;

    private final Executor executor = new Executor();

    private static Game mmneatGame(long seed) {
        return new Game(seed, GameRules.mmneat(), new ResumableRandom(0));
    }

    private static String printed(Runnable action) {
        PrintStream before = System.out;
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        System.setOut(new PrintStream(text, true, StandardCharsets.UTF_8));
        try {
            action.run();
        } finally {
            System.setOut(before);
        }
        return text.toString(StandardCharsets.UTF_8);
    }

    @Test
    void batch_printsEachScoreAndTheirMean_ofGamesWithFixedSeeds() {
        ResumableRandom seeds = new ResumableRandom(0);
        Game first = new Game(seeds.nextLong());
        Game second = new Game(seeds.nextLong());
        executor.runExperiment(new StarterPacMan(), new Legacy(), first);
        executor.runExperiment(new StarterPacMan(), new Legacy(), second);
        String text = printed(() -> executor.runExperiment(new StarterPacMan(), new Legacy(), 2));
        assertThat(text.lines())
                .containsExactly(
                        "0\t" + first.getScore(),
                        "1\t" + second.getScore(),
                        Double.toString((first.getScore() + second.getScore()) / 2.0));
    }

    @Test
    void controllerThatThrows_isNamedInTheExceptionThatLeavesTheRun() {
        assertThatThrownBy(() -> executor.runExperiment(new Throwing(), new Legacy(), new Game(0)))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("no idea at 0")
                .satisfies(failure -> {
                    ControllerFailure report = ControllerFailure.in(failure).orElseThrow();
                    assertThat(report.controllerName()).isEqualTo(Throwing.class.getName());
                    assertThat(report.totalTime()).isZero();
                });
    }

    /** An exception without suppressed exceptions, thrown repeatedly. */
    private static final class Light extends RuntimeException {
        private static final long serialVersionUID = 1;

        Light() {
            super("light", null, false, false);
        }
    }

    private static Controller<MOVE> throwing(RuntimeException failure) {
        return new Controller<>() {
            @Override
            public MOVE getMove(Game game, long timeDue) {
                throw failure;
            }
        };
    }

    @Test
    void exceptionThatKeepsNoReport_isTheReportsCause() {
        RuntimeException light = new Light();
        assertThatThrownBy(() -> executor.runExperiment(throwing(light), new Legacy(), new Game(0)))
                .isInstanceOf(ControllerFailure.class)
                .hasCause(light)
                .satisfies(
                        failure -> assertThat(ControllerFailure.in(failure)).containsSame((ControllerFailure) failure));
    }

    @Test
    void exceptionThatIsThrownAgain_isReportedAnew() {
        RuntimeException same = new IllegalStateException("again");
        Game game = new Game(0);
        assertThatThrownBy(() -> executor.runExperiment(throwing(same), new Legacy(), game))
                .isSameAs(same);
        while (game.getTotalTime() < 7) {
            game.advanceGame(MOVE.LEFT, null);
        }
        assertThatThrownBy(() -> executor.runExperiment(throwing(same), new Legacy(), game))
                .isSameAs(same);
        assertThat(ControllerFailure.in(same).orElseThrow().totalTime()).isEqualTo(7);
    }

    /** A controller that records due times and is slow in its first answer. */
    private static final class Punctual<T> extends Controller<T> {
        private final List<Long> due = new ArrayList<>();

        @Override
        public T getMove(Game game, long timeDue) {
            if (due.isEmpty()) {
                try {
                    Thread.sleep(20);
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }
            due.add(timeDue);
            return null;
        }
    }

    @Test
    void batch_givesBothControllersTheirOwnForty_milliseconds() {
        Punctual<MOVE> pacMan = new Punctual<>();
        Punctual<EnumMap<GHOST, MOVE>> ghosts = new Punctual<>();
        printed(() -> executor.runExperiment(pacMan, ghosts, 1));
        assertThat(ghosts.due.get(0) - pacMan.due.get(0)).isGreaterThanOrEqualTo(19);
    }

    @Test
    void fixedTime_waitsForTheRestOfEachDelay() {
        Game game = mmneatGame(0);
        long start = System.nanoTime();
        executor.runGameTimedSpeedOptimised(new Silent(), new NoGhosts(), true, false, game);
        long milliseconds = (System.nanoTime() - start) / 1_000_000;
        assertThat(game.getTotalTime()).isEqualTo(11);
        assertThat(milliseconds).isGreaterThanOrEqualTo(10L * Constants.DELAY);
    }

    @Test
    void supervisors_endWithTheGame() throws InterruptedException {
        executor.runGameTimedSpeedOptimised(new Silent(), new NoGhosts(), false, false, mmneatGame(0));
        List<String> names =
                List.of("supervisor of " + Silent.class.getName(), "supervisor of " + NoGhosts.class.getName());
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            if (names.contains(thread.getName())) {
                thread.join();
            }
        }
    }

    @Test
    void recordingOfAGameThatWasWon_isReplayedToItsEnd() {
        for (int powerPill = 0; powerPill < 4; powerPill++) {
            GameRules rules = GameRules.isolatedGhosts(powerPill, GhostLocations.shipped());
            Game game = new Game(powerPill, rules, new ResumableRandom(powerPill));
            String text = executor.runGameRecorded(new StarterPacMan(), new Legacy(), game);
            Game last = executor.replayGame(new Recording(text.lines().toList()), rules, false, 0);
            assertThat(last.getCurrentLevel())
                    .isGreaterThanOrEqualTo(rules.levels().maximumLevel());
            assertThat(last.getScore()).isEqualTo(game.getScore());
        }
    }

    @Test
    void nullPacManMove_endsTheGameAtTimeEleven_byMmNeatsRulesOnly() {
        Game game = mmneatGame(0);
        executor.runExperiment(new Silent(), new Legacy(), game);
        assertThat(game.getTotalTime()).isEqualTo(11);
        Game competition = new Game(0);
        executor.runExperiment(new Silent(), new Legacy(), competition);
        assertThat(competition.getTotalTime()).isGreaterThan(11);
        assertThat(competition.gameOver()).isTrue();
    }

    @Test
    void nullGhostMap_isPassedOn_soThatTheEngineDecides() {
        Game game = new Game(0);
        executor.runExperiment(new StarterPacMan(), new NoGhosts(), game);
        Game byHand = new Game(0);
        StarterPacMan pacMan = new StarterPacMan();
        while (!byHand.gameOver()) {
            byHand.advanceGame(pacMan.getMove(byHand.copy(), -1), null);
        }
        assertThat(game.getGameState()).isEqualTo(byHand.getGameState());
    }

    @Test
    void timedGame_continuesWithoutAControllerThatThrew_andEndsByItsMissingAnswer() {
        Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler((thread, failure) -> {});
        try {
            Game game = mmneatGame(0);
            executor.runGameTimedSpeedOptimised(new Throwing(), new Legacy(), false, false, game);
            assertThat(game.gameOver()).isTrue();
            assertThat(game.getTotalTime()).isEqualTo(11);
        } finally {
            Thread.setDefaultUncaughtExceptionHandler(before);
        }
    }

    @Test
    void timedModes_playToTheEnd_alsoVisuallyWithoutADisplay() {
        Game game = executor.runGameTimed(new Silent(), new Legacy(), true, mmneatGame(0));
        assertThat(game.gameOver()).isTrue();
        Game fixed = mmneatGame(0);
        executor.runGameTimedSpeedOptimised(new Silent(), new Legacy(), true, true, fixed);
        assertThat(fixed.gameOver()).isTrue();
        Game human = new Game(
                0, GameRules.mmneat().withLevels(levels -> levels.withMaximumLevel(1)), new ResumableRandom(0));
        executor.runGame(new HumanController(new KeyBoardInput()), new Legacy(), human, true, 0);
        assertThat(human.gameOver()).isTrue();
    }

    @Test
    void untimedVisualGame_isTheSameGame_withoutADisplay() {
        Game seen = new Game(5);
        executor.runGame(new NearestPillPacManVS(), new Legacy(), seen, true, 0);
        Game unseen = new Game(5);
        executor.runExperiment(new NearestPillPacManVS(), new Legacy(), unseen);
        assertThat(seen.getGameState()).isEqualTo(unseen.getGameState());
    }

    @Test
    void interrupt_endsATimedGame() {
        Game game = new Game(0);
        Thread.currentThread().interrupt();
        executor.runGameTimed(new Silent(), new Legacy(), false, game);
        assertThat(Thread.interrupted()).isTrue();
        assertThat(game.gameOver()).isFalse();
    }

    @Test
    void timedRecording_hasALinePerTickAndALineEnd() throws IOException {
        Path file = folder.resolve("game.txt");
        executor.runGameTimedRecorded(mmneatGame(0), new Silent(), new Legacy(), false, file.toString());
        String text = Files.readString(file);
        assertThat(text).endsWith(System.lineSeparator());
        List<String> lines = text.lines().toList();
        // The twelfth call ends the game without a tick, and is also recorded.
        assertThat(lines).hasSize(12);
        assertThat(lines).allSatisfy(line -> assertThat(line.split(",")).hasSize(56));
        assertThat(lines.get(10)).isEqualTo(lines.get(11));
        assertThat(Recording.load(file).rules().conventions()).isEqualTo(GameRules.Conventions.MM_NEAT);
    }

    @Test
    void replay_showsTheStatesOfARecording() throws IOException {
        Game game = new Game(3);
        String text = executor.runGameRecorded(new StarterPacMan(), new Legacy(), game);
        Path file = folder.resolve("game.txt");
        Executor.saveToFile(text, file.toString(), false);
        Recording recording = Recording.load(file);
        assertThat(recording.states()).hasSize(game.getTotalTime());
        Game replayed = executor.replayGame(recording, recording.rules(), true, 0);
        assertThat(replayed.getGameState()).isEqualTo(game.getGameState());
        executor.replayGame(file.toString(), false, 0);
    }

    @Test
    void replay_stopsWhenTheLastLevelIsOver() {
        GameRules shortLevels = GameRules.mmneat()
                .withLevels(levels -> levels.withLevelTimeLimit(30).withFatalTimeLimit(false));
        Game game = new Game(0, shortLevels, new ResumableRandom(0));
        List<String> states = new ArrayList<>();
        while (game.getCurrentLevel() < 2) {
            states.add(game.getGameState());
            game.advanceGame(MOVE.LEFT, null);
        }
        GameRules oneLevel = shortLevels.withLevels(levels -> levels.withMaximumLevel(1));
        Game last = executor.replayGame(new Recording(states), oneLevel, false, 0);
        assertThat(last.getCurrentLevel()).isOne();
        assertThat(last.getCurrentLevelTime())
                .as("the first state behind the last level")
                .isZero();
        assertThat(states).hasSizeGreaterThan(50);
    }

    @Test
    void recordingThatIsNone_isRefusedWithAReason() throws IOException {
        assertThatThrownBy(() -> new Recording(List.of())).hasMessage("the recording is empty");
        assertThatThrownBy(() -> new Recording(List.of("a,b"))).hasMessageContaining("but the first line has 2");
        String state = new Game(0).getGameState();
        assertThatThrownBy(() -> new Recording(List.of(state, "a,b"))).hasMessageContaining("state 2 has 2 fields");
        Path binary = Files.write(folder.resolve("binary"), new byte[] {(byte) 0xff, (byte) 0xfe, 0, 1});
        assertThatThrownBy(() -> Recording.load(binary)).hasMessageContaining("not a text file");
        assertThatThrownBy(() -> executor.replayGame(folder.resolve("none").toString(), false))
                .isInstanceOf(UncheckedIOException.class);
    }

    @Test
    void saveToFile_appendsOrOverwrites_andPrintsAFailure() throws IOException {
        Path file = folder.resolve("data.txt");
        Executor.saveToFile("a", file.toString(), false);
        Executor.saveToFile("b", file.toString(), true);
        assertThat(Files.readAllLines(file)).containsExactly("a", "b");
        Executor.saveToFile("c", file.toString(), false);
        assertThat(Files.readAllLines(file)).containsExactly("c");
        assertThat(printed(() -> Executor.saveToFile("d", folder.toString(), false))
                        .lines())
                .containsExactly("Could not save data!");
    }

    @Test
    void experiment_returnsTheScoresOfItsGames_andPrintsNothing() {
        ExperimentResult[] results = new ExperimentResult[2];
        String text = printed(() -> {
            results[0] = executor.runExperiment(StarterPacMan::new, Legacy::new, 3, 7);
            results[1] = executor.runExperiment(StarterPacMan::new, Legacy::new, 3, 7, GameRules.competition());
        });
        assertThat(text).isEmpty();
        assertThat(results[0]).isEqualTo(results[1]);
        GameSeries series = new GameSeries(GameRules.competition(), 7);
        long steps = 0;
        for (int score : results[0].scores()) {
            Game game = series.next();
            executor.runExperiment(new StarterPacMan(), new Legacy(), game);
            assertThat(game.getScore()).isEqualTo(score);
            steps += game.getTotalTime();
        }
        assertThat(results[0].steps()).isEqualTo(steps);
        for (int trials : new int[] {0, -1}) {
            assertThatThrownBy(() -> executor.runExperiment(new StarterPacMan(), new Legacy(), trials))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("trials must be at least 1, is " + trials);
        }
        assertThatThrownBy(() -> executor.runExperiment(StarterPacMan::new, Legacy::new, 0, 7))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("games must be at least 1, is 0");
    }

    @Test
    void result_hasTheMean() {
        ExperimentResult result = new ExperimentResult(List.of(100, 300, 200), 30);
        assertThat(result.mean()).isEqualTo(200);
        assertThatThrownBy(() -> new ExperimentResult(List.of(), 0)).hasMessageContaining("at least one game");
    }

    @Test
    void humansGame_waitsForTheFirstKey() throws InterruptedException {
        KeyBoardInput input = new KeyBoardInput();
        Thread waiting = new Thread(() -> Executor.awaitKey(input));
        waiting.start();
        while (waiting.getState() != Thread.State.TIMED_WAITING) {
            Thread.onSpinWait();
        }
        assertThat(waiting.isAlive()).isTrue();
        JLabel window = new JLabel();
        input.keyPressed(new KeyEvent(window, KeyEvent.KEY_PRESSED, 0, 0, KeyEvent.VK_LEFT, KeyEvent.CHAR_UNDEFINED));
        waiting.join();
    }

    /** A controller that answers the first state after its step, and records how many threads are deciding. */
    private static final class Tardy extends Controller<MOVE> {
        private final AtomicInteger inside = new AtomicInteger();
        private volatile int most;
        private final Semaphore allowed = new Semaphore(0);

        @Override
        public MOVE getMove(Game game, long timeDue) {
            most = Math.max(most, inside.incrementAndGet());
            allowed.acquireUninterruptibly();
            inside.decrementAndGet();
            return game.getTotalTime() > 5 ? null : MOVE.LEFT;
        }
    }

    @Test
    void timedReport_namesLateAnswersAndRepeatedMovesPerSide() {
        Tardy tardy = new Tardy();
        Game game = mmneatGame(0);
        AtomicInteger steps = new AtomicInteger();
        TimedRun run = new TimedRun(tardy, new NoGhosts(), TimedRun.Waiting.UNTIL_ANSWERED);
        // Only the first state is answered after its step.
        TimedReport report = run.play(game, state -> {
            if (steps.incrementAndGet() == 1) {
                tardy.allowed.release();
            }
        });
        tardy.allowed.release(100);
        assertThat(report.pacMan().steps()).isEqualTo(steps.get());
        assertThat(report.pacMan().lateAnswers()).isOne();
        assertThat(report.pacMan().repeatedMoves()).isEqualTo(steps.get());
        assertThat(report.pacMan().exceptions()).isZero();
        assertThat(report.ghosts().exceptions()).isZero();
        assertThat(tardy.most).isOne();
    }

    @Test
    void timedReport_namesTheException_andTheStepsPlayedWithoutTheController() {
        Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler((thread, failure) -> {});
        try {
            TimedReport report = executor.runGameTimed(
                    new Throwing(), new NoGhosts(), mmneatGame(0), Executor.Pace.UNTIL_ANSWERED, false, state -> {});
            assertThat(report.pacMan().exceptions()).isOne();
            assertThat(report.pacMan().failure()).hasMessage("no idea at 0");
            assertThat(report.pacMan().repeatedMoves())
                    .isEqualTo(report.pacMan().steps())
                    .isEqualTo(12);
        } finally {
            Thread.setDefaultUncaughtExceptionHandler(before);
        }
    }

    @Test
    void realTime_isAtLeastFortyMillisecondsPerStep_howeverSoonTheAnswers() {
        long start = System.nanoTime();
        TimedReport report = executor.runGameTimed(
                new Silent(), new NoGhosts(), mmneatGame(0), Executor.Pace.REAL_TIME, false, state -> {});
        long milliseconds = (System.nanoTime() - start) / 1_000_000;
        assertThat(report.pacMan().steps()).isEqualTo(12);
        assertThat(milliseconds).isGreaterThanOrEqualTo(12L * Constants.DELAY);
    }
}
