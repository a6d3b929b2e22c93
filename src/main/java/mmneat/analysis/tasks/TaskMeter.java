package mmneat.analysis.tasks;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TrialGame;
import mmneat.mspacman.sensors.suite.NetworkInputs;
import mmneat.mspacman.sensors.suite.SensorSuite;
import mmneat.random.ResumableRandom;
import pacman.controllers.Controller;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/** Plays the games of a version and measures how they divide into tasks. */
public final class TaskMeter {

    private final TaskDivision division;
    private final List<TrialGame> games;
    private final Supplier<? extends Controller<EnumMap<GHOST, MOVE>>> ghosts;
    private final NetworkInputs sensors;

    /**
     * A meter for a version.
     *
     * @param settings which games make a trial, and the ghosts; the sensors and the number of trials do not matter
     */
    public TaskMeter(MsPacManTaskSettings settings, TaskDivision division) {
        this.division = division;
        games = settings.games().ofTrial();
        ghosts = settings.games().ghosts();
        sensors = SensorSuite.of(settings.networks().sensors()).newInputs();
    }

    /** Games, that is episodes, of a trial. */
    public int gamesPerTrial() {
        return games.size();
    }

    /**
     * Plays trials.
     *
     * @param player makes a controller for each game
     * @param seed the same seed and player give the same games
     * @param progress is told after each trial how many have been played
     */
    public TaskMeasurement measure(Supplier<Controller<MOVE>> player, int trials, long seed, IntConsumer progress) {
        ResumableRandom random = new ResumableRandom(seed);
        List<Episode> episodes = new ArrayList<>();
        for (int trial = 0; trial < trials; trial++) {
            for (TrialGame setting : games) {
                episodes.add(play(new Game(random.nextLong(), setting.rules(), random), player.get()));
            }
            progress.accept(trial + 1);
        }
        return new TaskMeasurement(division, episodes);
    }

    private Episode play(Game game, Controller<MOVE> player) {
        Controller<EnumMap<GHOST, MOVE>> team = ghosts.get();
        Episode.Counter counter = new Episode.Counter(division.tasks().size());
        while (!game.gameOver()) {
            sensors.observe(game);
            counter.step(division.tasksIn(sensors.observation()));
            game.advanceGame(player.getMove(game.copy(), -1), team.getMove(game.copy(), -1));
        }
        return counter.finish(game.getScore());
    }
}
