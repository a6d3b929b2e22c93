package mmneat.analysis.replay;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import mmneat.mspacman.DirectionEvaluator;
import mmneat.mspacman.EvaluationObserver;
import mmneat.mspacman.GameEnd;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TrialGame;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import pacman.game.Game;

/**
 * An animated GIF of a trial of a network (one game, or the five games of the isolated version), drawn by {@link
 * TrailPicture} at twice the size of the simulator's window. The last frame of a game names its outcome.
 *
 * <p>Every third step is a frame. In a long trial it is only every fourth step, every fifth and so on, so that there
 * are about {@value #MOST_FRAMES} frames at most and the file stays small.
 */
public final class GameGif implements EvaluationObserver {

    private static final int MOST_FRAMES = 1200;
    private static final int FEWEST_STEPS_PER_FRAME = 3;
    private static final int FRAME_CENTISECONDS = 6;
    private static final int LAST_FRAME_CENTISECONDS = 250;
    private static final int SCALE = 2;

    private final int modules;
    private final GifSequence sequence;
    private final int stepsPerFrame;

    @SuppressWarnings("NullAway.Init")
    private TrailPicture picture;

    @SuppressWarnings("NullAway.Init")
    private BufferedImage frame;

    @SuppressWarnings("NullAway.Init")
    private String title;

    private int step;
    private int frames;
    private final Progress progress;
    private final int expectedFrames;

    /** The receiver of the progress of the drawing: the numbers of frames drawn and expected. */
    public interface Progress {

        /**
         * Called after each frame.
         *
         * @param drawn frames so far
         * @param expected frames in all, to within a few
         */
        void frame(int drawn, int expected);
    }

    private GameGif(GifSequence sequence, int modules, int stepsPerFrame, int expectedFrames, Progress progress) {
        this.expectedFrames = expectedFrames;
        this.progress = progress;
        this.sequence = sequence;
        this.modules = modules;
        this.stepsPerFrame = stepsPerFrame;
    }

    /**
     * Plays one trial (one game, or the five games of the isolated version) and writes it as a GIF.
     *
     * @param settings the rules; the number of trials does not matter
     * @param seed of the trial's generator: the same seed gives the same games
     * @return number of frames
     */
    public static int write(
            MsPacManTaskSettings settings, Genotype genotype, long seed, OutputStream out, Progress progress)
            throws IOException {
        MsPacManTask task = new MsPacManTask(settings.forSingleGames());
        long steps =
                task.evaluate(genotype, new ResumableRandom(seed)).outcomes().steps();
        int stepsPerFrame = (int) Math.max(FEWEST_STEPS_PER_FRAME, 1 + steps / MOST_FRAMES);
        try (GifSequence sequence = new GifSequence(out)) {
            GameGif gif = new GameGif(
                    sequence, genotype.modules(), stepsPerFrame, (int) (steps / stepsPerFrame) + 1, progress);
            task.evaluate(genotype, new ResumableRandom(seed), gif);
            return gif.frames;
        }
    }

    @Override
    public void gameStarted(TrialGame setting, Game game) {
        picture = new TrailPicture(game, modules);
        frame = picture.newImage(SCALE);
        title = GameRecording.name(setting);
        step = 0;
        addFrame(game, FRAME_CENTISECONDS);
    }

    @Override
    public void stepPlayed(Game game, DirectionEvaluator player) {
        if (picture.add(game, player) && ++step % stepsPerFrame == 0 && !game.gameOver()) {
            addFrame(game, FRAME_CENTISECONDS);
        }
    }

    @Override
    public void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {
        title = GameRecording.outcome(game, end);
        addFrame(game, LAST_FRAME_CENTISECONDS);
    }

    private void addFrame(Game game, int centiseconds) {
        picture.paint(game);
        picture.draw(frame, SCALE, title);
        sequence.add(frame, centiseconds);
        frames++;
        progress.frame(frames, Math.max(frames, expectedFrames));
    }
}
