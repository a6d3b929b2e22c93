package pacman.game;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsEnvironment;
import java.awt.RenderingHints;
import java.awt.Toolkit;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Vector;
import java.util.WeakHashMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicReference;
import javax.imageio.ImageIO;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.internal.Maze;
import pacman.game.internal.Node;

/**
 * The view of a game: maze, pills, Ms.&nbsp;Pac-Man, ghosts, and debug drawings of controllers.
 *
 * <p>Part of the competition's programming interface, in which debug drawing is static: controllers in any thread add
 * squares and lines, each shown in one painting. Without a view they are dropped; at most {@value #DEBUG_LIMIT} of each
 * kind are kept. On a machine without a display a view exists but shows nothing.
 *
 * <p>Source: docs/specification/controllers.md, section 7.
 */
public final class GameView extends JComponent {

    /** Squares to draw in the next painting; public in the competition's interface. */
    public static Vector<DebugPointer> debugPointers = new Vector<>();

    /** Lines to draw in the next painting; public in the competition's interface. */
    public static Vector<DebugLine> debugLines = new Vector<>();

    /** Maximum number of squares, and of lines, kept for the next painting. */
    private static final int DEBUG_LIMIT = 20_000;

    private static final AtomicReference<String> IMAGE_TO_SAVE = new AtomicReference<>();

    /** The views that are still referenced. If there are none, debug drawing is dropped. */
    private static final Map<GameView, Boolean> VIEWS = Collections.synchronizedMap(new WeakHashMap<>());

    private static final int PICTURE_WIDTH = Constants.GV_WIDTH * Constants.MAG;
    private static final int PICTURE_HEIGHT = Constants.GV_HEIGHT * Constants.MAG + 20;
    /** Points of the labels' font: smaller than the default, so that score, level and time fit beside the lives. */
    private static final float LABEL_SIZE = 10;

    private static final int SHOW_DELAY_MILLISECONDS = 2000;

    /**
     * A window opens at the largest multiple of the picture's size that is not higher than this share of the screen.
     */
    private static final double LARGEST_SHARE_OF_SCREEN = 0.85;

    private final Game game;
    private final Images images = new Images();
    private final transient Map<Maze, BufferedImage> mazePictures = new ConcurrentHashMap<>();

    /** The state that the event thread paints. The game itself continues in another thread. */
    private transient volatile Game painted;

    private volatile String announcement = "";
    private MOVE facing;
    private @Nullable GameFrame frame;

    /**
     * @param game the game to show while it is played
     */
    public GameView(Game game) {
        this.game = game;
        painted = game.snapshot();
        facing = game.getPacmanLastMoveMade();
        VIEWS.put(this, true);
    }

    // ------------------------------------------------------------------------------------------- debug drawing

    /** Draws a square on each node in the next painting. */
    public static synchronized void addPoints(Game game, Color colour, int... nodes) {
        if (VIEWS.isEmpty()) {
            return;
        }
        for (int node : nodes) {
            keep(debugPointers, new DebugPointer(game.getNodeXCoord(node), game.getNodeYCoord(node), colour));
        }
    }

    /** Draws a line from each node of {@code from} to the node at the same index in {@code to}. */
    public static synchronized void addLines(Game game, Color colour, int[] from, int[] to) {
        for (int i = 0; i < from.length; i++) {
            addLines(game, colour, from[i], to[i]);
        }
    }

    /** Draws a line between two nodes in the next painting. */
    public static synchronized void addLines(Game game, Color colour, int from, int to) {
        if (VIEWS.isEmpty()) {
            return;
        }
        keep(
                debugLines,
                new DebugLine(
                        game.getNodeXCoord(from),
                        game.getNodeYCoord(from),
                        game.getNodeXCoord(to),
                        game.getNodeYCoord(to),
                        colour));
    }

    private static <T> void keep(Vector<T> drawings, T drawing) {
        if (drawings.size() < DEBUG_LIMIT) {
            drawings.add(drawing);
        }
    }

    /** Saves the next painting as {@code myData/<name>.png}; the folder is not created. */
    public static synchronized void saveImage(String name) {
        IMAGE_TO_SAVE.set(name);
    }

    private static synchronized <T> List<T> takeAll(Vector<T> drawings) {
        List<T> all = List.copyOf(drawings);
        drawings.clear();
        return all;
    }

    // ------------------------------------------------------------------------------------------- painting

    /** Requests a repaint of the current state. The thread that plays the game must call it. */
    @Override
    public void repaint() {
        if (game != null && !SwingUtilities.isEventDispatchThread()) {
            painted = game.snapshot();
        }
        super.repaint();
    }

    @Override
    public void paintComponent(Graphics screen) {
        BufferedImage image = new BufferedImage(PICTURE_WIDTH, PICTURE_HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics graphics = image.createGraphics();
        paintState(graphics, SwingUtilities.isEventDispatchThread() ? painted : game);
        graphics.dispose();
        drawScaled(image, screen);
        String name = IMAGE_TO_SAVE.getAndSet(null);
        if (name != null) {
            save(image, name);
        }
    }

    /**
     * Draws the picture centred and as large as the component allows. At whole multiples of its size, pixels are square
     * and sharp; otherwise the next larger multiple is scaled down.
     */
    private void drawScaled(BufferedImage image, Graphics screen) {
        double scale = Math.min((double) getWidth() / PICTURE_WIDTH, (double) getHeight() / PICTURE_HEIGHT);
        scale = scale > 0 ? scale : 1;
        int width = (int) Math.round(scale * PICTURE_WIDTH);
        int height = (int) Math.round(scale * PICTURE_HEIGHT);
        screen.setColor(Color.BLACK);
        screen.fillRect(0, 0, getWidth(), getHeight());
        int left = Math.max(0, (getWidth() - width) / 2);
        int top = Math.max(0, (getHeight() - height) / 2);
        if (scale == Math.rint(scale)) {
            screen.drawImage(image, left, top, width, height, null);
            return;
        }
        int multiple = (int) Math.ceil(scale);
        BufferedImage large =
                new BufferedImage(multiple * PICTURE_WIDTH, multiple * PICTURE_HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics graphics = large.createGraphics();
        graphics.drawImage(image, 0, 0, large.getWidth(), large.getHeight(), null);
        graphics.dispose();
        Graphics2D smooth = (Graphics2D) screen.create();
        smooth.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        smooth.drawImage(large, left, top, width, height, null);
        smooth.dispose();
    }

    private static void save(BufferedImage image, String name) {
        File file = new File("myData", name + ".png");
        try {
            ImageIO.write(image, "png", file);
        } catch (IOException e) {
            System.err.println("Could not save " + file + ": " + e);
        }
    }

    /**
     * Paints in the order of docs/specification/controllers.md, section 7.2; the offsets are those of its table, except
     * for the text.
     */
    private void paintState(Graphics graphics, Game state) {
        graphics.setColor(Color.BLACK);
        graphics.fillRect(0, 0, PICTURE_WIDTH, PICTURE_HEIGHT);
        Maze maze = state.shownMaze();
        graphics.drawImage(
                mazePictures.computeIfAbsent(maze, drawn -> MazePicture.of(drawn, state.shownMazeIndex())), 2, 6, null);
        paintDebugDrawing(graphics);
        paintPills(graphics, state, maze);
        paintPacMan(graphics, state, maze);
        paintGhosts(graphics, state, maze);
        paintLives(graphics, state);
        paintText(graphics, state);
    }

    private static void paintDebugDrawing(Graphics graphics) {
        for (DebugPointer point : takeAll(debugPointers)) {
            graphics.setColor(point.colour);
            graphics.fillRect(point.x * Constants.MAG + 1, point.y * Constants.MAG + 5, 10, 10);
        }
        for (DebugLine line : takeAll(debugLines)) {
            graphics.setColor(line.colour);
            graphics.drawLine(
                    line.x1 * Constants.MAG + 5,
                    line.y1 * Constants.MAG + 10,
                    line.x2 * Constants.MAG + 5,
                    line.y2 * Constants.MAG + 10);
        }
    }

    private static void paintPills(Graphics graphics, Game state, Maze maze) {
        graphics.setColor(Color.WHITE);
        for (int pill = 0; pill < maze.pillIndices.length; pill++) {
            if ((state.pillBits(pill >> 6) >>> pill & 1) != 0) {
                Node node = maze.graph[maze.pillIndices[pill]];
                graphics.fillOval(node.x * Constants.MAG + 4, node.y * Constants.MAG + 8, 3, 3);
            }
        }
        for (int powerPill = 0; powerPill < maze.powerPillIndices.length; powerPill++) {
            if ((state.powerPillBits() >>> powerPill & 1) != 0) {
                Node node = maze.graph[maze.powerPillIndices[powerPill]];
                graphics.fillOval(node.x * Constants.MAG + 1, node.y * Constants.MAG + 5, 8, 8);
            }
        }
    }

    private void paintPacMan(Graphics graphics, Game state, Maze maze) {
        MOVE move = state.getPacmanLastMoveMade();
        if (move != MOVE.NEUTRAL) {
            facing = move;
        }
        Node node = maze.graph[state.getPacmanCurrentNodeIndex()];
        graphics.drawImage(
                images.getPacMan(facing, state.getTotalTime()),
                node.x * Constants.MAG - 1,
                node.y * Constants.MAG + 3,
                null);
    }

    private void paintGhosts(Graphics graphics, Game state, Maze maze) {
        int time = state.getTotalTime();
        for (GHOST ghost : GHOST.values()) {
            Node node = maze.graph[state.getGhostCurrentNodeIndex(ghost)];
            int x = node.x * Constants.MAG - 1;
            int y = node.y * Constants.MAG + 3;
            if (state.getGhostEdibleTime(ghost) > 0) {
                boolean blinking = state.getGhostEdibleTime(ghost) < Constants.EDIBLE_ALERT;
                graphics.drawImage(images.getEdibleGhost(blinking, time), x, y, null);
            } else {
                int shift = state.getGhostLairTime(ghost) > 0 ? 5 * ghost.ordinal() : 0;
                graphics.drawImage(images.getGhost(ghost, state.getGhostLastMoveMade(ghost), time), x + shift, y, null);
            }
        }
    }

    private void paintLives(Graphics graphics, Game state) {
        for (int i = 0; i < state.getPacmanNumberOfLivesRemaining() - 1; i++) {
            graphics.drawImage(images.getPacManForExtraLives(), 210 - 15 * i, 260, null);
        }
    }

    /** Shows a text in the middle of the picture, such as what the spectator has to do; an empty text removes it. */
    public void announce(String text) {
        announcement = text;
        repaint();
    }

    private void paintText(Graphics graphics, Game state) {
        if (!MachineFonts.areAvailable()) {
            return;
        }
        graphics.setColor(Color.WHITE);
        graphics.setFont(graphics.getFont().deriveFont(LABEL_SIZE));
        graphics.drawString("Score " + state.getScore(), 4, 271);
        graphics.drawString("Level " + (state.getCurrentLevel() + 1), 76, 271);
        graphics.drawString("Time " + state.getCurrentLevelTime(), 122, 271);
        String middle = state.gameOver() ? "Game Over" : announcement;
        if (!middle.isEmpty()) {
            FontMetrics metrics = graphics.getFontMetrics();
            graphics.drawString(middle, (PICTURE_WIDTH - metrics.stringWidth(middle)) / 2, 150);
        }
    }

    // ------------------------------------------------------------------------------------------- window

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(PICTURE_WIDTH, PICTURE_HEIGHT);
    }

    /** Opens a window, waits two seconds, and returns this view. Without a display it returns immediately. */
    public GameView showGame() {
        if (!GraphicsEnvironment.isHeadless()) {
            frame = new GameFrame(this);
            try {
                Thread.sleep(SHOW_DELAY_MILLISECONDS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
        return this;
    }

    /** The window; null before {@link #showGame}, and without a display. */
    public @Nullable GameFrame getFrame() {
        return frame;
    }

    /** A resizable window with a view. Closing it ends the program. */
    public class GameFrame extends JFrame {

        public GameFrame(JComponent view) {
            Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();
            int scale = Math.max(1, (int) (LARGEST_SHARE_OF_SCREEN * screen.height / PICTURE_HEIGHT));
            getContentPane().setPreferredSize(new Dimension(scale * PICTURE_WIDTH, scale * PICTURE_HEIGHT));
            getContentPane().add(BorderLayout.CENTER, view);
            pack();
            setLocationRelativeTo(null);
            setTitle("Ms. Pac-Man");
            setDefaultCloseOperation(EXIT_ON_CLOSE);
            setVisible(true);
            repaint();
        }
    }

    /** The pictures of the actors and mazes. The program draws them; no files are read. */
    public class Images {

        private final Sprites sprites = new Sprites();

        public Images() {}

        /** Ms.&nbsp;Pac-Man facing a direction; the game step chooses how far her mouth is open. */
        public BufferedImage getPacMan(MOVE move, int time) {
            return sprites.pacMan(move, time);
        }

        /** The symbol of a life. */
        public BufferedImage getPacManForExtraLives() {
            return sprites.pacMan(MOVE.RIGHT, 0);
        }

        /** A ghost facing a direction; the game step chooses one of two pictures. */
        public BufferedImage getGhost(GHOST ghost, MOVE move, int time) {
            return sprites.ghost(ghost, move, time);
        }

        /** An edible ghost; the game step chooses one of two pictures. */
        public BufferedImage getEdibleGhost(boolean blinking, int time) {
            return sprites.edibleGhost(blinking, time);
        }

        /** The walls of one of the four mazes of the competition, 224 by 248 pixels. */
        public BufferedImage getMaze(int mazeIndex) {
            return MazePicture.of(new Game(0, mazeIndex).getCurrentMaze(), mazeIndex);
        }
    }

    /** A debug square, in maze pixels. */
    private record DebugPointer(int x, int y, Color colour) {}

    /** A debug line, in maze pixels. */
    private record DebugLine(int x1, int y1, int x2, int y2, Color colour) {}
}
