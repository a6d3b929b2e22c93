package pacman.game;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.GeneralPath;
import java.awt.geom.Line2D;
import java.awt.image.BufferedImage;
import java.util.EnumMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;

/** Small pictures of Ms. Pac-Man and the ghosts, drawn once. NEUTRAL looks up. */
final class Sprites {

    /** Width and height of a picture in screen pixels. */
    static final int SIZE = 14;

    private static final int GHOST_FRAMES = 2;

    /** Half the angle of the mouth in degrees: normal, open, closed. */
    private static final double[] MOUTHS = {25, 50, 4};

    private static final Color PACMAN_COLOUR = new Color(255, 230, 0);
    private static final Color EDIBLE_COLOUR = new Color(40, 60, 255);

    private final Map<MOVE, BufferedImage[]> pacMan = new EnumMap<>(MOVE.class);
    private final Map<GHOST, Map<MOVE, BufferedImage[]>> ghosts = new EnumMap<>(GHOST.class);
    private final BufferedImage[] edible = new BufferedImage[GHOST_FRAMES];
    private final BufferedImage blinking;

    Sprites() {
        for (MOVE move : MOVE.values()) {
            BufferedImage[] frames = new BufferedImage[MOUTHS.length];
            for (int frame = 0; frame < frames.length; frame++) {
                double mouth = MOUTHS[frame];
                frames[frame] = picture(graphics -> paintPacMan(graphics, move, mouth));
            }
            pacMan.put(move, frames);
        }
        for (GHOST ghost : GHOST.values()) {
            Map<MOVE, BufferedImage[]> directions = new EnumMap<>(MOVE.class);
            for (MOVE move : MOVE.values()) {
                BufferedImage[] frames = new BufferedImage[GHOST_FRAMES];
                for (int i = 0; i < frames.length; i++) {
                    int frame = i;
                    frames[frame] = picture(graphics -> {
                        paintGhostBody(graphics, colour(ghost), frame);
                        paintEyes(graphics, move);
                    });
                }
                directions.put(move, frames);
            }
            ghosts.put(ghost, directions);
        }
        for (int i = 0; i < GHOST_FRAMES; i++) {
            int frame = i;
            edible[frame] = picture(graphics -> paintFrightened(graphics, EDIBLE_COLOUR, Color.WHITE, frame));
        }
        blinking = picture(graphics -> paintFrightened(graphics, Color.WHITE, Color.RED, 0));
    }

    /** @param time game step, which chooses one of three mouths, two steps each */
    BufferedImage pacMan(MOVE move, int time) {
        return Objects.requireNonNull(pacMan.get(move))[time % 6 / 2];
    }

    /** @param time game step, which chooses one of two pictures, three steps each */
    BufferedImage ghost(GHOST ghost, MOVE move, int time) {
        return Objects.requireNonNull(Objects.requireNonNull(ghosts.get(ghost)).get(move))[time % 6 / 3];
    }

    /** @param isBlinking whether the edible time is almost over; then every other picture is bright */
    BufferedImage edibleGhost(boolean isBlinking, int time) {
        int frame = time % 6 / 3;
        return isBlinking && frame == 0 ? blinking : edible[frame];
    }

    private static Color colour(GHOST ghost) {
        return switch (ghost) {
            case BLINKY -> new Color(255, 40, 30);
            case PINKY -> new Color(255, 170, 220);
            case INKY -> new Color(40, 230, 230);
            case SUE -> new Color(255, 170, 60);
        };
    }

    private static BufferedImage picture(Consumer<Graphics2D> painter) {
        BufferedImage image = new BufferedImage(SIZE, SIZE, BufferedImage.TYPE_INT_ARGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        painter.accept(graphics);
        graphics.dispose();
        return image;
    }

    private static void paintPacMan(Graphics2D graphics, MOVE move, double mouth) {
        // Degrees, counterclockwise from the right.
        double facing =
                switch (move) {
                    case RIGHT -> 0;
                    case UP, NEUTRAL -> 90;
                    case LEFT -> 180;
                    case DOWN -> 270;
                };
        graphics.setColor(PACMAN_COLOUR);
        graphics.fill(new Arc2D.Double(0.5, 0.5, 13, 13, facing + mouth, 360 - 2 * mouth, Arc2D.PIE));
        // The bow is at the back of the head.
        double back = Math.toRadians(facing + 135);
        graphics.setColor(Color.RED);
        graphics.fill(new Ellipse2D.Double(5.2 + 4.6 * Math.cos(back), 5.2 - 4.6 * Math.sin(back), 3.6, 3.6));
    }

    private static void paintGhostBody(Graphics2D graphics, Color colour, int frame) {
        GeneralPath body = new GeneralPath();
        body.moveTo(1, 13);
        body.lineTo(1, 7);
        body.curveTo(1, -1.5, 13, -1.5, 13, 7);
        body.lineTo(13, 13);
        // The skirt: waves with crests and valleys swapped between the two pictures.
        double crest = frame == 0 ? 11 : 13;
        double valley = frame == 0 ? 13 : 11;
        body.lineTo(11, crest);
        body.lineTo(9, valley);
        body.lineTo(7, crest);
        body.lineTo(5, valley);
        body.lineTo(3, crest);
        body.closePath();
        graphics.setColor(colour);
        graphics.fill(body);
    }

    private static void paintEyes(Graphics2D graphics, MOVE move) {
        int dx = move == MOVE.LEFT ? -1 : move == MOVE.RIGHT ? 1 : 0;
        int dy = move == MOVE.DOWN ? 1 : dx == 0 ? -1 : 0;
        for (int x : new int[] {3, 8}) {
            graphics.setColor(Color.WHITE);
            graphics.fill(new Ellipse2D.Double(x + 0.5 * dx, 4 + 0.5 * dy, 3.6, 4));
            graphics.setColor(new Color(20, 20, 160));
            graphics.fill(new Ellipse2D.Double(x + 0.8 + 1.2 * dx, 5 + 1.3 * dy, 2, 2));
        }
    }

    private static void paintFrightened(Graphics2D graphics, Color body, Color face, int frame) {
        paintGhostBody(graphics, body, frame);
        graphics.setColor(face);
        graphics.fill(new Ellipse2D.Double(4, 4.5, 2, 2));
        graphics.fill(new Ellipse2D.Double(8, 4.5, 2, 2));
        graphics.setStroke(new BasicStroke(1));
        for (int x = 3; x < 11; x += 2) {
            boolean rising = (x / 2) % 2 == 0;
            graphics.draw(new Line2D.Double(x, rising ? 9.5 : 8.5, x + 2, rising ? 8.5 : 9.5));
        }
    }
}
