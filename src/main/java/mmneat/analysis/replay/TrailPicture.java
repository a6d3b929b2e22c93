package mmneat.analysis.replay;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import mmneat.mspacman.DirectionEvaluator;
import pacman.game.Constants;
import pacman.game.Game;
import pacman.game.GameView;
import pacman.game.MachineFonts;

/**
 * An image of a network's game: the view of the simulator's window ({@link GameView}), enlarged, with Ms. Pac-Man's
 * trail in the current maze in one colour per module, and a legend below. The playing thread draws it; no display is
 * needed.
 */
final class TrailPicture {

    private static final int DIRECTIONS = 4;
    private static final int BLACK = 0xff000000;

    /** Maximum number of modules in the legend. */
    private static final int MOST_NAMED = 4;

    private static final int LINE_HEIGHT = 30;
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.BOLD, 14);

    private final int modules;
    private final GameView view;
    private final BufferedImage image;
    private final List<int[]> trail = new ArrayList<>();
    private int level;

    /** @param modules of the network that plays */
    TrailPicture(Game game, int modules) {
        this.modules = modules;
        view = new GameView(game);
        Dimension size = view.getPreferredSize();
        image = new BufferedImage(size.width, size.height, BufferedImage.TYPE_INT_RGB);
        level = game.getCurrentLevel();
    }

    /**
     * Appends a step to the trail.
     *
     * @return whether to show the step; false if the game ended at the start of a level that is never played
     */
    boolean add(Game game, DirectionEvaluator player) {
        boolean isNewLevel = game.getCurrentLevel() != level;
        if (isNewLevel && game.gameOver()) {
            return false;
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
        return true;
    }

    /** Paints the current state of the game. After the end of its last level the image stays unchanged. */
    void paint(Game game) {
        if (game.getCurrentLevel() == level) {
            Graphics2D graphics = image.createGraphics();
            view.paintComponent(graphics);
            graphics.dispose();
            paintTrail(game);
        }
    }

    /** An image that {@link #draw} fills. */
    BufferedImage newImage(int scale) {
        return new BufferedImage(
                scale * image.getWidth(), scale * image.getHeight() + LINE_HEIGHT, BufferedImage.TYPE_INT_RGB);
    }

    /** The largest scale, at least 1, at which an image is not larger than that. */
    int scaleWithin(int width, int height) {
        return Math.max(1, Math.min(width / image.getWidth(), (height - LINE_HEIGHT) / image.getHeight()));
    }

    /**
     * Draws the image that was painted last, and the legend below it.
     *
     * @param target of {@link #newImage}, of the same scale
     * @param title which game this is, or how it ended
     */
    void draw(BufferedImage target, int scale, String title) {
        Graphics2D graphics = target.createGraphics();
        graphics.setColor(Color.BLACK);
        graphics.fillRect(0, 0, target.getWidth(), target.getHeight());
        graphics.drawImage(image, 0, 0, scale * image.getWidth(), scale * image.getHeight(), null);
        drawLine(graphics, target.getWidth(), target.getHeight(), title);
        graphics.dispose();
    }

    private void drawLine(Graphics2D graphics, int width, int height, String title) {
        if (!MachineFonts.areAvailable()) {
            return;
        }
        graphics.setFont(FONT);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        int margin = LINE_HEIGHT / 3;
        int base = height - margin;
        graphics.setColor(Color.WHITE);
        graphics.drawString(title, width - graphics.getFontMetrics().stringWidth(title) - margin, base);
        int x = margin;
        for (int module = 0; module < Math.min(modules, MOST_NAMED); module++) {
            graphics.setColor(ModuleColours.of(module));
            graphics.fillRect(x, base - 11, 12, 12);
            String name = (module == 0 ? "module " : "") + (module + 1);
            graphics.drawString(name, x + 17, base);
            x += 17 + graphics.getFontMetrics().stringWidth(name) + LINE_HEIGHT / 2;
        }
    }

    /**
     * Colours only black pixels, newest steps first. So the trail lies below everything else, and older parts below
     * newer ones.
     */
    private void paintTrail(Game game) {
        for (int step = trail.size() - 1; step >= 0; step--) {
            int[] place = trail.get(step);
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
