package mmneat.analysis.replay;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.Objects;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.KeyStroke;
import mmneat.mspacman.DirectionEvaluator;
import mmneat.mspacman.EvaluationObserver;
import mmneat.mspacman.GameEnd;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TrialGame;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Game;

/**
 * A window that shows a trial of a network while it is played, as {@link TrailPicture} draws its games. The space bar
 * pauses and resumes the game; closing the window ends the program.
 */
public final class GameWindow implements EvaluationObserver {

    private static final int LOOK_MILLISECONDS = 2000;

    /** The window opens at the largest whole scale that leaves this share of the screen free. */
    private static final double LARGEST_SHARE_OF_SCREEN = 0.85;

    private final int modules;
    private final int millisecondsPerStep;
    private final Canvas canvas = new Canvas();
    private @Nullable JFrame frame;

    @SuppressWarnings("NullAway.Init")
    private TrailPicture picture;

    @SuppressWarnings("NullAway.Init")
    private String title;

    private int score;

    private GameWindow(int modules, int millisecondsPerStep) {
        this.modules = modules;
        this.millisecondsPerStep = millisecondsPerStep;
    }

    /**
     * Plays and shows one trial: one game, or the five games of the isolated version. Needs a display.
     *
     * @param seed of the trial's generator: the same seed gives the same games
     * @return points of all its games
     */
    public static int show(MsPacManTaskSettings settings, Genotype genotype, long seed, int millisecondsPerStep) {
        GameWindow window = new GameWindow(genotype.modules(), millisecondsPerStep);
        new MsPacManTask(settings.forSingleGames()).evaluate(genotype, new ResumableRandom(seed), window);
        Objects.requireNonNull(window.frame, "the game has been shown").dispose();
        return window.score;
    }

    @Override
    public void gameStarted(TrialGame setting, Game game) {
        picture = new TrailPicture(game, modules);
        title = GameRecording.name(setting);
        if (frame == null) {
            open();
        }
        show(game);
        pause(LOOK_MILLISECONDS);
    }

    private void open() {
        Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();
        int scale = picture.scaleWithin(
                (int) (LARGEST_SHARE_OF_SCREEN * screen.width), (int) (LARGEST_SHARE_OF_SCREEN * screen.height));
        BufferedImage image = picture.newImage(scale);
        canvas.setPreferredSize(new Dimension(image.getWidth(), image.getHeight()));
        frame = new JFrame("Ms. Pac-Man (space: pause, continue)");
        frame.add(canvas);
        frame.pack();
        frame.setLocationRelativeTo(null);
        frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
        frame.setVisible(true);
    }

    @Override
    public void stepPlayed(Game game, DirectionEvaluator player) {
        if (picture.add(game, player)) {
            show(game);
            pause(millisecondsPerStep);
            canvas.waitWhileHalted();
        }
    }

    @Override
    public void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {
        score += game.getScore();
        title = GameRecording.outcome(game, end);
        show(game);
        pause(LOOK_MILLISECONDS);
    }

    private void show(Game game) {
        picture.paint(game);
        int scale = picture.scaleWithin(canvas.getWidth(), canvas.getHeight());
        BufferedImage image = picture.newImage(scale);
        picture.draw(image, scale, title);
        canvas.show(image);
    }

    private static void pause(int milliseconds) {
        try {
            Thread.sleep(milliseconds);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** The component in which the event thread shows the image that the playing thread drew last. */
    private static final class Canvas extends JComponent {

        private transient @Nullable BufferedImage shown;
        private boolean halted;

        Canvas() {
            String action = "pause or continue";
            getInputMap(WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(KeyEvent.VK_SPACE, 0), action);
            getActionMap().put(action, new AbstractAction() {
                @Override
                public void actionPerformed(ActionEvent event) {
                    haltOrGoOn();
                }
            });
        }

        synchronized void show(BufferedImage image) {
            shown = image;
            repaint();
        }

        synchronized void waitWhileHalted() {
            try {
                while (halted) {
                    wait();
                }
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }

        private synchronized void haltOrGoOn() {
            halted = !halted;
            notifyAll();
        }

        @Override
        protected synchronized void paintComponent(Graphics graphics) {
            graphics.setColor(Color.BLACK);
            graphics.fillRect(0, 0, getWidth(), getHeight());
            if (shown != null) {
                graphics.drawImage(
                        shown, (getWidth() - shown.getWidth()) / 2, (getHeight() - shown.getHeight()) / 2, null);
            }
        }
    }
}
