package mmneat.analysis.replay;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import mmneat.mspacman.DirectionEvaluator;
import mmneat.mspacman.EvaluationObserver;
import mmneat.mspacman.GameEnd;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TrialGame;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import pacman.game.Constants;
import pacman.game.Game;
import pacman.game.GameView;

/**
 * A trial of a network as an animated picture: the competition's view of the game, with Ms. Pac-Man's trail in this maze in one
 * colour per module.
 *
 * <p>There are at most {@value #MOST_FRAMES} frames, of every third step or fewer, so that a whole game stays small.
 */
public final class GameGif implements EvaluationObserver {

    private static final int MOST_FRAMES = 1200;
    private static final int FEWEST_STEPS_PER_FRAME = 3;
    private static final int FRAME_CENTISECONDS = 6;
    private static final int LAST_FRAME_CENTISECONDS = 250;

    private static final int DIRECTIONS = 4;
    private static final int BLACK = 0xff000000;

    /** Colours of the modules, as on the replay page; further modules begin again. */
    private static final int[] MODULES = {
        0xffffb000, 0xff5b8cff, 0xffe8327c, 0xff35d3b0, 0xffb48cff, 0xffff7a2e, 0xff9fe84a, 0xffc9d2f0
    };

    private final GifSequence sequence;
    private final int stepsPerFrame;
    private final List<int[]> trail = new ArrayList<>();
    private GameView view;
    private BufferedImage image;
    private int level;
    private int step;
    private int frames;

    private GameGif(GifSequence sequence, int stepsPerFrame) {
        this.sequence = sequence;
        this.stepsPerFrame = stepsPerFrame;
    }

    /**
     * Plays one trial and writes it.
     *
     * @param settings the rules; the number of trials does not matter
     * @param seed of the trial's generator: the same seed gives the same games
     * @return number of frames
     */
    public static int write(MsPacManTaskSettings settings, Genotype genotype, long seed, OutputStream out)
            throws IOException {
        MsPacManTask task = new MsPacManTask(settings.forSingleGames());
        long steps =
                task.evaluate(genotype, new ResumableRandom(seed)).outcomes().steps();
        int stepsPerFrame = (int) Math.max(FEWEST_STEPS_PER_FRAME, 1 + steps / MOST_FRAMES);
        try (GifSequence sequence = new GifSequence(out)) {
            GameGif gif = new GameGif(sequence, stepsPerFrame);
            task.evaluate(genotype, new ResumableRandom(seed), gif);
            return gif.frames;
        }
    }

    @Override
    public void gameStarted(TrialGame setting, Game game) {
        view = new GameView(game);
        image = new BufferedImage(
                view.getPreferredSize().width, view.getPreferredSize().height, BufferedImage.TYPE_INT_RGB);
        level = game.getCurrentLevel();
        step = 0;
        trail.clear();
        addFrame(game, FRAME_CENTISECONDS);
    }

    @Override
    public void stepPlayed(Game game, DirectionEvaluator player) {
        boolean isNewLevel = game.getCurrentLevel() != level;
        if (isNewLevel && game.gameOver()) {
            // The game is at the start of a level that is never played; the picture stays at the end of the last one.
            return;
        }
        if (isNewLevel) {
            level = game.getCurrentLevel();
            trail.clear();
        } else {
            int direction = game.getPacmanLastMoveMade().ordinal();
            int module = direction < DIRECTIONS ? player.lastModule(direction) : 0;
            trail.add(new int[] {game.getPacmanCurrentNodeIndex(), MODULES[module % MODULES.length]});
        }
        step++;
        if (step % stepsPerFrame == 0 && !game.gameOver()) {
            addFrame(game, FRAME_CENTISECONDS);
        }
    }

    @Override
    public void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {
        if (game.getCurrentLevel() == level) {
            addFrame(game, LAST_FRAME_CENTISECONDS);
        } else {
            sequence.add(image, LAST_FRAME_CENTISECONDS);
            frames++;
        }
    }

    private void addFrame(Game game, int centiseconds) {
        Graphics2D graphics = image.createGraphics();
        view.paintComponent(graphics);
        graphics.dispose();
        paintTrail(game);
        sequence.add(image, centiseconds);
        frames++;
    }

    /** Only what is black is painted, so that the trail lies below everything else. */
    private void paintTrail(Game game) {
        for (int[] place : trail) {
            int left = game.getNodeXCoord(place[0]) * Constants.MAG + 5;
            int top = game.getNodeYCoord(place[0]) * Constants.MAG + 9;
            for (int x = left; x < left + Constants.MAG; x++) {
                for (int y = top; y < top + Constants.MAG; y++) {
                    if (image.getRGB(x, y) == BLACK) {
                        image.setRGB(x, y, place[1]);
                    }
                }
            }
        }
    }
}
