package pacman.game;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Map;
import pacman.game.Constants.MOVE;
import pacman.game.internal.Maze;
import pacman.game.internal.Node;

/** Draws the walls of a maze from its graph: the corridors are cut out of a wider outline around them. */
final class MazePicture {

    static final int WIDTH = 224;
    static final int HEIGHT = 248;

    /**
     * Offset of a node's centre in the picture, to the right and down, from its coordinates times {@link
     * Constants#MAG}.
     */
    private static final int OFFSET = 4;

    private static final float CORRIDOR_WIDTH = 13;
    private static final float WALL_WIDTH = 1.6f;

    private static final Color[] WALL_COLOURS = {
        new Color(90, 110, 255), new Color(40, 190, 170), new Color(230, 130, 60), new Color(190, 100, 230)
    };

    /** The lair's interior, relative to the lair node, in maze pixels: four ghosts wide. */
    private static final Rectangle2D LAIR = new Rectangle2D.Double(-5, -5, 20, 10);

    private MazePicture() {}

    /** @param index number of the maze, which chooses the colour of its walls */
    static BufferedImage of(Maze maze, int index) {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_ARGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        Path2D corridors = corridors(maze);
        graphics.setColor(WALL_COLOURS[Math.floorMod(index, WALL_COLOURS.length)]);
        graphics.setStroke(brush(CORRIDOR_WIDTH + 2 * WALL_WIDTH));
        graphics.draw(corridors);
        paintLair(graphics, maze.graph[maze.lairNodeIndex]);
        graphics.setColor(Color.BLACK);
        graphics.setStroke(brush(CORRIDOR_WIDTH));
        graphics.draw(corridors);
        graphics.dispose();
        return image;
    }

    private static BasicStroke brush(float width) {
        return new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }

    /** Returns one line per pair of neighbours. Tunnels continue beyond the border of the picture. */
    private static Path2D corridors(Maze maze) {
        Path2D lines = new Path2D.Double();
        for (Node node : maze.graph) {
            for (Map.Entry<MOVE, Integer> way : node.neighbourhood.entrySet()) {
                Node next = maze.graph[way.getValue()];
                boolean adjacent = Math.abs(node.x - next.x) + Math.abs(node.y - next.y) == 1;
                double endX = adjacent ? centre(next.x) : way.getKey() == MOVE.LEFT ? -WIDTH : 2 * WIDTH;
                lines.append(new Line2D.Double(centre(node.x), centre(node.y), endX, centre(next.y)), false);
            }
        }
        return lines;
    }

    private static void paintLair(Graphics2D graphics, Node lair) {
        Rectangle2D room = new Rectangle2D.Double(
                centre(lair.x) + Constants.MAG * LAIR.getX(),
                centre(lair.y) + Constants.MAG * LAIR.getY(),
                Constants.MAG * LAIR.getWidth(),
                Constants.MAG * LAIR.getHeight());
        graphics.setStroke(new BasicStroke(WALL_WIDTH));
        graphics.draw(room);
        graphics.setColor(new Color(255, 180, 210));
        graphics.setStroke(new BasicStroke(2 * WALL_WIDTH, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER));
        double middle = room.getCenterX();
        graphics.draw(new Line2D.Double(middle - 7, room.getY(), middle + 7, room.getY()));
    }

    private static double centre(int coordinate) {
        return Constants.MAG * coordinate + OFFSET;
    }
}
