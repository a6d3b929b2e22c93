package mmneat.analysis.replay;

import mmneat.mspacman.DirectionEvaluator;
import mmneat.mspacman.EvaluationObserver;
import mmneat.mspacman.GameEnd;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TrialGame;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import pacman.game.Game;
import pacman.game.GameView;

/** Shows a trial of a network in a window while it is played. Closing the window ends the program. */
public final class GameWindow implements EvaluationObserver {

    private static final int LAST_LOOK_MILLISECONDS = 2000;

    private final int millisecondsPerStep;
    private GameView view;
    private int level;
    private int score;

    private GameWindow(int millisecondsPerStep) {
        this.millisecondsPerStep = millisecondsPerStep;
    }

    /**
     * Plays one trial; needs a display.
     *
     * @param seed of the trial's generator: the same seed gives the same games
     * @return points of all its games
     */
    public static int show(MsPacManTaskSettings settings, Genotype genotype, long seed, int millisecondsPerStep) {
        GameWindow window = new GameWindow(millisecondsPerStep);
        new MsPacManTask(settings.forSingleGames()).evaluate(genotype, new ResumableRandom(seed), window);
        return window.score;
    }

    @Override
    public void gameStarted(TrialGame setting, Game game) {
        level = game.getCurrentLevel();
        view = new GameView(game).showGame();
    }

    @Override
    public void stepPlayed(Game game, DirectionEvaluator player) {
        if (game.gameOver() && game.getCurrentLevel() != level) {
            // The game is at the start of a level that is never played; the picture stays at the end of the last one.
            return;
        }
        level = game.getCurrentLevel();
        view.repaint();
        pause(millisecondsPerStep);
    }

    @Override
    public void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {
        score += game.getScore();
        pause(LAST_LOOK_MILLISECONDS);
        view.getFrame().dispose();
    }

    private static void pause(int milliseconds) {
        try {
            Thread.sleep(milliseconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
