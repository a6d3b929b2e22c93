package mmneat.analysis.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.List;

/**
 * An entry of a figure's legend.
 *
 * @param text what it means
 * @param sign how it looks
 * @param color its colour
 * @param stroke of a line; null otherwise
 */
record Key(String text, Sign sign, Color color, BasicStroke stroke) {

    enum Sign {
        LINE,
        AREA,
        POINT
    }

    static final int HEIGHT = 30;

    private static final int SIGN_WIDTH = 28;
    private static final int GAP = 8;
    private static final int BETWEEN = 26;
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);

    /** Draws entries in one row, in the middle of a width. */
    static void paint(Graphics2D graphics, List<Key> keys, int width) {
        double all = -BETWEEN;
        for (Key key : keys) {
            all += SIGN_WIDTH + GAP + Letters.width(key.text, FONT) + BETWEEN;
        }
        double x = (width - all) / 2;
        double middle = HEIGHT / 2.0 - 3;
        for (Key key : keys) {
            key.paintSign(graphics, x, middle);
            graphics.setColor(Color.BLACK);
            Letters.draw(graphics, key.text, FONT, x + SIGN_WIDTH + GAP, middle + 4);
            x += SIGN_WIDTH + GAP + Letters.width(key.text, FONT) + BETWEEN;
        }
    }

    private void paintSign(Graphics2D graphics, double x, double middle) {
        graphics.setColor(color);
        switch (sign) {
            case LINE -> {
                graphics.setStroke(stroke);
                graphics.draw(new Line2D.Double(x, middle, x + SIGN_WIDTH, middle));
            }
            case AREA -> graphics.fill(new Rectangle2D.Double(x + 4, middle - 6, SIGN_WIDTH - 8, 12));
            case POINT -> graphics.fill(new Ellipse2D.Double(x + SIGN_WIDTH / 2.0 - 4, middle - 4, 8, 8));
        }
    }
}
