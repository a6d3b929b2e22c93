package pacman;

import java.io.FileWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import pacman.controllers.Controller;
import pacman.controllers.HumanController;
import pacman.controllers.KeyBoardInput;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.StarterPacMan;
import pacman.game.Constants;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GameRules;
import pacman.game.GameView;

/**
 * Plays games between two controllers: without a time limit or in real time, shown in a window, or recorded.
 *
 * <p>In untimed games an exception of a controller leaves the method; it carries a {@link ControllerFailure} that names
 * the controller. In timed games it ends the controller's thread, whose name Java prints with it, and the game
 * continues with the last answer. Views are shown only if there is a display.
 *
 * <p>To measure a controller, begin with {@link #runExperiment(Supplier, Supplier, int, long)}: it gives each game new
 * controllers, so that games do not affect each other, and returns the scores. A variant of it also takes the rules.
 * The methods that take a {@link Game} play one game by the rules of that game. The other methods are those of the
 * competition's programming interface: they play with the competition's rules and a fixed seed, and return no scores.
 *
 * <p>Source: the programming interface of the competition, release 6.2, and the variants that MM-NEAT added, which take
 * the game to play ({@link pacman} explains both names); docs/specification/controllers.md, section 6.
 */
public class Executor {

    /** The duration of a step of a timed game: fixed, or as short as the controllers allow. */
    public enum Pace {
        /** Real time: {@value Constants#DELAY} ms, even if the controllers answer earlier. */
        REAL_TIME,
        /** Until both controllers have answered, at most {@value Constants#DELAY} ms. */
        UNTIL_ANSWERED
    }

    /** Seed from which the seeds of a batch of games are drawn. */
    private static final long BATCH_SEED = 0;

    private static final int KEY_LOOK_MILLISECONDS = 10;

    private static final Consumer<Game> NOTHING = game -> {};

    /** Shows a game of {@link StarterPacMan} against {@link Legacy}. */
    public static void main(String[] arguments) {
        new Executor().runGameTimed(new StarterPacMan(), new Legacy(), true);
    }

    // ------------------------------------------------------------------------------------------- untimed games

    /**
     * Plays games with fixed seeds and prints the score of each, and at the end their mean.
     *
     * @param trials number of games, at least 1
     * @throws IllegalArgumentException if it is less than 1
     */
    public void runExperiment(
            Controller<MOVE> pacManController, Controller<EnumMap<GHOST, MOVE>> ghostController, int trials) {
        requireGames("trials", trials);
        GameSeries games = new GameSeries(GameRules.competition(), BATCH_SEED);
        UntimedRun run = new UntimedRun(pacManController, ghostController, UntimedRun.DueTime.PER_CONTROLLER);
        double sum = 0;
        for (int trial = 0; trial < trials; trial++) {
            Game game = games.next();
            run.play(game);
            sum += game.getScore();
            System.out.println(trial + "\t" + game.getScore());
        }
        System.out.println(sum / trials);
    }

    /**
     * Plays games by the rules of the competition ({@link GameRules#competition}) and returns their scores; prints
     * nothing.
     *
     * @param pacMan makes Ms. Pac-Man's controller, a new one for each game
     * @param ghosts makes the ghosts' controller, a new one for each game
     * @param games number of games, at least 1
     * @param seed the same seed gives the same games
     */
    public ExperimentResult runExperiment(
            Supplier<? extends Controller<MOVE>> pacMan,
            Supplier<? extends Controller<EnumMap<GHOST, MOVE>>> ghosts,
            int games,
            long seed) {
        return runExperiment(pacMan, ghosts, games, seed, GameRules.competition());
    }

    /**
     * Plays games by given rules and returns their scores; prints nothing.
     *
     * @param pacMan makes Ms. Pac-Man's controller, a new one for each game
     * @param ghosts makes the ghosts' controller, a new one for each game
     * @param games number of games, at least 1
     * @param seed the same seed and rules give the same games
     */
    public ExperimentResult runExperiment(
            Supplier<? extends Controller<MOVE>> pacMan,
            Supplier<? extends Controller<EnumMap<GHOST, MOVE>>> ghosts,
            int games,
            long seed,
            GameRules rules) {
        requireGames("games", games);
        GameSeries series = new GameSeries(rules, seed);
        List<Integer> scores = new ArrayList<>();
        long steps = 0;
        for (int number = 0; number < games; number++) {
            Game game = series.next();
            runExperiment(pacMan.get(), ghosts.get(), game);
            scores.add(game.getScore());
            steps += game.getTotalTime();
        }
        return new ExperimentResult(scores, steps);
    }

    private static void requireGames(String name, int games) {
        if (games < 1) {
            throw new IllegalArgumentException(name + " must be at least 1, is " + games);
        }
    }

    /** Plays the given game to its end. */
    public void runExperiment(
            Controller<MOVE> pacManController, Controller<EnumMap<GHOST, MOVE>> ghostController, Game game) {
        new UntimedRun(pacManController, ghostController, UntimedRun.DueTime.ONCE_PER_TICK).play(game);
    }

    /**
     * Plays the given game to its end.
     *
     * @param afterStep called after each step with the game
     */
    public void runExperiment(
            Controller<MOVE> pacManController,
            Controller<EnumMap<GHOST, MOVE>> ghostController,
            Game game,
            Consumer<Game> afterStep) {
        new UntimedRun(pacManController, ghostController, UntimedRun.DueTime.ONCE_PER_TICK).play(game, afterStep);
    }

    /** Plays a game with seed 0, and waits {@code delay} ms after each tick (game step). */
    public void runGame(
            Controller<MOVE> pacManController,
            Controller<EnumMap<GHOST, MOVE>> ghostController,
            boolean visual,
            int delay) {
        runGame(pacManController, ghostController, new Game(0), visual, delay);
    }

    /** Plays the given game, and waits {@code delay} ms after each tick; an interrupt ends the waiting. */
    public void runGame(
            Controller<MOVE> pacManController,
            Controller<EnumMap<GHOST, MOVE>> ghostController,
            Game game,
            boolean visual,
            int delay) {
        runGame(pacManController, ghostController, game, visual, delay, NOTHING);
    }

    /**
     * Plays the given game, and waits {@code delay} ms after each tick; an interrupt ends the waiting.
     *
     * @param afterStep called after each step with the game
     */
    public void runGame(
            Controller<MOVE> pacManController,
            Controller<EnumMap<GHOST, MOVE>> ghostController,
            Game game,
            boolean visual,
            int delay,
            Consumer<Game> afterStep) {
        Consumer<Game> show = painter(visual ? new GameView(game).showGame() : null);
        new UntimedRun(pacManController, ghostController, UntimedRun.DueTime.NONE).play(game, state -> {
            afterStep.accept(state);
            pause(delay);
            show.accept(state);
        });
    }

    /** Plays the given game as fast as the controllers answer, and returns its recording: see {@link #saveToFile}. */
    public String runGameRecorded(
            Controller<MOVE> pacManController, Controller<EnumMap<GHOST, MOVE>> ghostController, Game game) {
        Recording.Recorder recording = new Recording.Recorder();
        new UntimedRun(pacManController, ghostController, UntimedRun.DueTime.ONCE_PER_TICK).play(game, recording::add);
        return recording.text();
    }

    // ------------------------------------------------------------------------------------------- timed games

    /** Plays a game with seed 0 at 40 ms per tick. */
    public void runGameTimed(
            Controller<MOVE> pacManController, Controller<EnumMap<GHOST, MOVE>> ghostController, boolean visual) {
        runGameTimed(pacManController, ghostController, visual, new Game(0));
    }

    /** Plays the given game at 40 ms per tick, closes the window, and returns the game. */
    public Game runGameTimed(
            Controller<MOVE> pacManController,
            Controller<EnumMap<GHOST, MOVE>> ghostController,
            boolean visual,
            Game game) {
        GameView view = visual ? window(game, pacManController) : null;
        new TimedRun(pacManController, ghostController, TimedRun.Waiting.FULL_DELAY).play(game, painter(view));
        if (view != null && view.getFrame() != null) {
            view.getFrame().dispose();
        }
        return game;
    }

    /**
     * Plays the given game with each controller in its own thread, and returns how punctual they were. A controller
     * that throws an exception keeps its last answer, and the game continues.
     *
     * @param visual whether the game is shown, if there is a display
     * @param afterStep called after each step with the game, in the calling thread
     */
    public TimedReport runGameTimed(
            Controller<MOVE> pacManController,
            Controller<EnumMap<GHOST, MOVE>> ghostController,
            Game game,
            Pace pace,
            boolean visual,
            Consumer<Game> afterStep) {
        TimedRun.Waiting waiting =
                pace == Pace.REAL_TIME ? TimedRun.Waiting.FULL_DELAY : TimedRun.Waiting.UNTIL_ANSWERED;
        Consumer<Game> show = painter(visual ? window(game, pacManController) : null);
        return new TimedRun(pacManController, ghostController, waiting).play(game, afterStep.andThen(show));
    }

    /**
     * Plays a game with seed 0; a tick lasts until both controllers have answered, at most about 40 ms.
     *
     * @param fixedTime whether the rest of the 40 ms is waited for after the answers
     */
    public void runGameTimedSpeedOptimised(
            Controller<MOVE> pacManController,
            Controller<EnumMap<GHOST, MOVE>> ghostController,
            boolean fixedTime,
            boolean visual) {
        runGameTimedSpeedOptimised(pacManController, ghostController, fixedTime, visual, new Game(0));
    }

    /**
     * Plays the given game; a tick lasts until both controllers have answered, at most about 40 ms.
     *
     * <p>With {@code fixedTime} every tick lasts about 40 ms, so the game runs as with {@link #runGameTimed}, except
     * that the window stays open. Only without it is the game faster.
     *
     * @param fixedTime whether the rest of the 40 ms is waited for after the answers
     */
    public void runGameTimedSpeedOptimised(
            Controller<MOVE> pacManController,
            Controller<EnumMap<GHOST, MOVE>> ghostController,
            boolean fixedTime,
            boolean visual,
            Game game) {
        TimedRun.Waiting waiting = fixedTime ? TimedRun.Waiting.FIXED_TIME : TimedRun.Waiting.UNTIL_ANSWERED;
        GameView view = visual ? window(game, pacManController) : null;
        new TimedRun(pacManController, ghostController, waiting).play(game, painter(view));
    }

    /** Plays a game with seed 0 at 40 ms per tick and writes its recording. */
    public void runGameTimedRecorded(
            Controller<MOVE> pacManController,
            Controller<EnumMap<GHOST, MOVE>> ghostController,
            boolean visual,
            String fileName) {
        runGameTimedRecorded(new Game(0), pacManController, ghostController, visual, fileName);
    }

    /** Plays the given game at 40 ms per tick and writes its recording. */
    public void runGameTimedRecorded(
            Game game,
            Controller<MOVE> pacManController,
            Controller<EnumMap<GHOST, MOVE>> ghostController,
            boolean visual,
            String fileName) {
        Recording.Recorder recording = new Recording.Recorder();
        Consumer<Game> show = painter(visual ? window(game, pacManController) : null);
        new TimedRun(pacManController, ghostController, TimedRun.Waiting.FULL_DELAY).play(game, state -> {
            recording.add(state);
            show.accept(state);
        });
        saveToFile(recording.text(), fileName, false);
    }

    // ------------------------------------------------------------------------------------------- replay

    /** Shows a recording at 40 ms per tick. */
    public void replayGame(String fileName, boolean visual) {
        replayGame(fileName, visual, Constants.DELAY);
    }

    /** Shows a recording at {@code delay} ms per tick. */
    public void replayGame(String fileName, boolean visual, int delay) {
        try {
            Recording recording = Recording.load(Path.of(fileName));
            replayGame(recording, recording.rules(), visual, delay);
        } catch (IOException e) {
            throw new UncheckedIOException("could not read the recording " + fileName, e);
        }
    }

    /**
     * Shows a recording. It stops at the first state whose level is not a level of the rules ({@link
     * pacman.game.LevelRules#maximumLevel}): such a state follows the last level and has no maze to show. Rules without
     * a last level show the whole recording.
     *
     * @param rules rules of the recorded game, or other rules with the same mazes
     * @param delay milliseconds per tick
     * @return a game in the last state shown
     * @throws IllegalArgumentException if a state cannot be read, or belongs to other mazes
     */
    public Game replayGame(Recording recording, GameRules rules, boolean visual, int delay) {
        Game game = new Game(0, rules);
        GameView view = null;
        for (String state : recording.states()) {
            game.setGameState(state);
            if (game.getCurrentLevel() >= rules.levels().maximumLevel()) {
                break;
            }
            if (visual) {
                view = view == null ? new GameView(game).showGame() : view;
                view.repaint();
            }
            pause(delay);
        }
        return game;
    }

    // ------------------------------------------------------------------------------------------- parts

    /**
     * Writes data and a line end to a file; a failure is printed.
     *
     * @param append whether to append to an existing file
     */
    public static void saveToFile(String data, String fileName, boolean append) {
        // Not written through a channel: the interrupt that ends a timed game would lose the recording.
        try (Writer file = new FileWriter(fileName, StandardCharsets.UTF_8, append)) {
            file.write(data);
            file.write(System.lineSeparator());
        } catch (IOException e) {
            System.out.println("Could not save data!");
            System.err.println(fileName + ": " + e);
        }
    }

    /**
     * Opens a window. For a human player, the window supplies the key presses, and the game waits for the first one.
     */
    private static GameView window(Game game, Controller<MOVE> pacManController) {
        GameView view = new GameView(game);
        if (!(pacManController instanceof HumanController human)) {
            return view.showGame();
        }
        view.announce("Press an arrow key");
        view.showGame();
        if (view.getFrame() != null) {
            view.getFrame().addKeyListener(human.getKeyboardInput());
            awaitKey(human.getKeyboardInput());
        }
        view.announce("");
        return view;
    }

    /** Returns when a key was pressed, or when the thread is interrupted. */
    static void awaitKey(KeyBoardInput input) {
        while (input.getKey() == 0 && !Thread.currentThread().isInterrupted()) {
            pause(KEY_LOOK_MILLISECONDS);
        }
    }

    /** Unlike in the original, the last state is also painted, as in release 6.2. */
    private static Consumer<Game> painter(@Nullable GameView view) {
        return view == null || view.getFrame() == null ? NOTHING : game -> view.repaint();
    }

    private static void pause(int milliseconds) {
        try {
            Thread.sleep(milliseconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
