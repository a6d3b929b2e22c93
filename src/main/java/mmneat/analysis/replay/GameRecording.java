package mmneat.analysis.replay;

import java.util.Arrays;
import java.util.Optional;
import mmneat.analysis.evaluation.ChampionLabels;
import mmneat.mspacman.DirectionEvaluator;
import mmneat.mspacman.EvaluationObserver;
import mmneat.mspacman.GameEnd;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TrialGame;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * A recording of a trial of a network that plays Ms.&nbsp;Pac-Man: one game, or the five games of the isolated version.
 * {@link #record} is the entry point; the other public methods are called by the game.
 */
public final class GameRecording implements EvaluationObserver {

    /** Maximum length of the data in characters; with it the page stays below 3 MB. */
    private static final int MOST_DATA = 2_800_000;

    private static final GHOST[] GHOSTS = GHOST.values();

    private final ReplayRecorder recorder;
    private final ReplayStep step;
    private final FullNetworkEvaluator networks;
    private final StateCapture state;

    private GameRecording(MsPacManTaskSettings settings, Genotype genotype, int detailEvery) {
        ReplayNetwork network = NetworkPicture.of(genotype, ChampionLabels.of(settings, genotype.layout()));
        recorder = new ReplayRecorder(network, detailEvery);
        step = new ReplayStep(network);
        state = new StateCapture(recorder, step);
        networks = new FullNetworkEvaluator(settings, genotype);
    }

    /**
     * Plays one trial (one game, or the five games of the isolated version) and records it.
     *
     * @param settings the rules; the number of trials does not matter
     * @param seed of the trial's generator: the same seed gives the same games
     */
    public static Replay record(MsPacManTaskSettings settings, Genotype genotype, long seed, ReplayTitle title) {
        return record(settings, genotype, seed, title, MOST_DATA);
    }

    /**
     * As above, with a maximum length of the data. If a recording is longer, sensor values and activations are kept
     * only in every second, fourth, ... step.
     */
    static Replay record(MsPacManTaskSettings settings, Genotype genotype, long seed, ReplayTitle title, int mostData) {
        MsPacManTask task = new MsPacManTask(settings.forSingleGames());
        for (int detailEvery = 1; ; detailEvery *= 2) {
            GameRecording recording = new GameRecording(settings, genotype, detailEvery);
            task.evaluate(genotype, new ResumableRandom(seed), recording);
            Replay replay = recording.recorder.finish(title);
            if (replay.dataLength() <= mostData || detailEvery > replay.steps()) {
                return replay;
            }
        }
    }

    @Override
    public void gameStarted(TrialGame setting, Game game) {
        recorder.startGame(name(setting));
        networks.startGame();
        capture(game);
    }

    /** The name of a game of a trial on the page; empty if it is the only game. */
    static String name(TrialGame setting) {
        if (setting.name().startsWith("GhostTask")) {
            int corner = Integer.parseInt(setting.name().substring("GhostTask".length()));
            return "Ghosts " + (corner + 1);
        }
        return setting.name().equals("PillTask") ? "Pills" : setting.name();
    }

    /**
     * Records the step that was just played: the state before the move, which was captured earlier, together with the
     * decision made in that state. Then the state after the move is captured for the next step.
     */
    @Override
    public void stepPlayed(Game game, DirectionEvaluator player) {
        MOVE made = game.getPacmanLastMoveMade();
        step.choice = ReplayStep.NO_MOVE;
        for (int d = 0; d < 4; d++) {
            step.preferences[d] = player.preference(d);
            step.modules[d] = player.lastModule(d);
            boolean better = step.open[d]
                    && (step.choice == ReplayStep.NO_MOVE
                            || step.preferences[d] > step.preferences[step.choice]
                            || step.preferences[d] == step.preferences[step.choice] && d == made.ordinal());
            step.choice = better ? d : step.choice;
        }
        step.module = step.choice == ReplayStep.NO_MOVE ? 0 : step.modules[step.choice];
        recorder.record(step);
        if (!game.gameOver()) {
            capture(game);
        }
    }

    @Override
    public void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {
        if (game.getCurrentLevel() == step.level) {
            state.capture(game);
        } else {
            finishLevel(game);
        }
        step.module = -1;
        step.choice = ReplayStep.NO_MOVE;
        recorder.record(step);
        recorder.endGame(outcome(game, end));
    }

    /** Records the end of the last level when the game stops at the start of a level that is never played. */
    private void finishLevel(Game game) {
        step.score = game.getScore();
        if (step.choice != ReplayStep.NO_MOVE) {
            int ahead = state.maze().neighbour(step.pacMan, step.choice);
            step.pacMan = ahead < 0 ? step.pacMan : ahead;
        }
        Arrays.fill(step.pills, false);
        Arrays.fill(step.powerPills, false);
    }

    /** How a game ended, with its points. */
    static String outcome(Game game, GameEnd end) {
        String what =
                switch (end) {
                    case ALL_LEVELS_BEATEN -> "All mazes cleared";
                    case LOST_ALL_LIVES ->
                        "Caught" + catcher(game).map(g -> " by " + g).orElse("");
                    case LEVEL_TIME_LIMIT -> "Time limit of the maze reached";
                    case GAME_TIME_LIMIT -> "Time limit of the game reached";
                    case PUNISHED -> "Ended by a power pill";
                };
        return what + " · " + String.format(java.util.Locale.ROOT, "%,d points", game.getScore());
    }

    private static Optional<String> catcher(Game game) {
        int here = game.getPacmanCurrentNodeIndex();
        GHOST nearest = null;
        int smallest = Integer.MAX_VALUE;
        for (GHOST ghost : GHOSTS) {
            if (game.isGhostEdible(ghost) || game.getGhostLairTime(ghost) > 0) {
                continue;
            }
            int distance = game.getShortestPathDistance(game.getGhostCurrentNodeIndex(ghost), here);
            if (distance >= 0 && distance < smallest) {
                smallest = distance;
                nearest = ghost;
            }
        }
        return Optional.ofNullable(nearest)
                .map(g -> g.name().charAt(0) + g.name().substring(1).toLowerCase(java.util.Locale.ROOT));
    }

    private void capture(Game game) {
        state.capture(game);
        networks.evaluate(game, step);
    }
}
