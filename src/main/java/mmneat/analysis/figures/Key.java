package mmneat.analysis.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
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
    static void paint(Canvas canvas, List<Key> keys, int width) {
        double all = -BETWEEN;
        for (Key key : keys) {
            all += SIGN_WIDTH + GAP + TextWidth.of(key.text, FONT) + BETWEEN;
        }
        double x = (width - all) / 2;
        double middle = HEIGHT / 2.0 - 3;
        for (Key key : keys) {
            key.paintSign(canvas, x, middle);
            canvas.text(key.text, x + SIGN_WIDTH + GAP, middle + 4, FONT, Color.BLACK, Canvas.Align.START);
            x += SIGN_WIDTH + GAP + TextWidth.of(key.text, FONT) + BETWEEN;
        }
    }

    private void paintSign(Canvas canvas, double x, double middle) {
        switch (sign) {
            case LINE -> canvas.draw(new Line2D.Double(x, middle, x + SIGN_WIDTH, middle), color, stroke);
            case AREA -> canvas.fill(new Rectangle2D.Double(x + 4, middle - 6, SIGN_WIDTH - 8, 12), color);
            case POINT -> canvas.fill(Marker.CIRCLE.at(x + SIGN_WIDTH / 2.0, middle), color);
        }
    }
}
