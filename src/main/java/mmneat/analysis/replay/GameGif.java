package mmneat.analysis.replay;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
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
 * A trial of a network as an animated picture: the competition's view of the game, twice as large, with Ms. Pac-Man's trail in this
 * maze in one colour per module, which a line below explains; at the end of a game it says how it ended.
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

    /** Most modules that the line below has room for. */
    private static final int MOST_NAMED = 4;

    private static final int SCALE = 2;
    private static final int LINE_HEIGHT = 30;
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.BOLD, 14);

    private final int modules;
    private final GifSequence sequence;
    private final int stepsPerFrame;
    private final List<int[]> trail = new ArrayList<>();
    private GameView view;
    private BufferedImage image;
    private BufferedImage frame;
    private String title;
    private int level;
    private int step;
    private int frames;

    private GameGif(GifSequence sequence, int modules, int stepsPerFrame) {
        this.sequence = sequence;
        this.modules = modules;
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
            GameGif gif = new GameGif(sequence, genotype.modules(), stepsPerFrame);
            task.evaluate(genotype, new ResumableRandom(seed), gif);
            return gif.frames;
        }
    }

    @Override
    public void gameStarted(TrialGame setting, Game game) {
        view = new GameView(game);
        image = new BufferedImage(
                view.getPreferredSize().width, view.getPreferredSize().height, BufferedImage.TYPE_INT_RGB);
        frame = new BufferedImage(
                SCALE * image.getWidth(), SCALE * image.getHeight() + LINE_HEIGHT, BufferedImage.TYPE_INT_RGB);
        title = GameRecording.name(setting);
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
            trail.add(new int[] {
                game.getPacmanCurrentNodeIndex(), ModuleColours.of(module).getRGB()
            });
        }
        step++;
        if (step % stepsPerFrame == 0 && !game.gameOver()) {
            addFrame(game, FRAME_CENTISECONDS);
        }
    }

    @Override
    public void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {
        if (game.getCurrentLevel() == level) {
            paint(game);
        }
        title = GameRecording.outcome(game, end);
        addFrame(LAST_FRAME_CENTISECONDS);
    }

    private void addFrame(Game game, int centiseconds) {
        paint(game);
        addFrame(centiseconds);
    }

    private void paint(Game game) {
        Graphics2D graphics = image.createGraphics();
        view.paintComponent(graphics);
        graphics.dispose();
        paintTrail(game);
    }

    private void addFrame(int centiseconds) {
        Graphics2D graphics = frame.createGraphics();
        graphics.setColor(Color.BLACK);
        graphics.fillRect(0, 0, frame.getWidth(), frame.getHeight());
        graphics.drawImage(image, 0, 0, SCALE * image.getWidth(), SCALE * image.getHeight(), null);
        paintLine(graphics);
        graphics.dispose();
        sequence.add(frame, centiseconds);
        frames++;
    }

    /** What the colours mean, and which game this is or how it ended. */
    private void paintLine(Graphics2D graphics) {
        graphics.setFont(FONT);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        int margin = LINE_HEIGHT / 3;
        int base = frame.getHeight() - margin;
        graphics.setColor(Color.WHITE);
        int width = graphics.getFontMetrics().stringWidth(title);
        graphics.drawString(title, frame.getWidth() - width - margin, base);
        int x = margin;
        for (int module = 0; module < Math.min(modules, MOST_NAMED); module++) {
            graphics.setColor(ModuleColours.of(module));
            graphics.fillRect(x, base - 11, 12, 12);
            String name = (module == 0 ? "module " : "") + (module + 1);
            graphics.drawString(name, x + 17, base);
            x += 17 + graphics.getFontMetrics().stringWidth(name) + LINE_HEIGHT / 2;
        }
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
