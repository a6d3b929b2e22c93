package mmneat.analysis.figures;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.font.FontRenderContext;
import java.awt.font.TextLayout;
import java.awt.geom.AffineTransform;

/** Text as outlines, as XChart draws its own: it then looks the same wherever an SVG is shown, whatever fonts are there. */
final class Letters {

    private static final FontRenderContext EXACT = new FontRenderContext(null, true, true);

    private Letters() {}

    /** Draws a text in the present colour; the place is the left end of its base line. */
    static void draw(Graphics2D graphics, String text, Font font, double x, double y) {
        graphics.fill(new TextLayout(text, font, EXACT).getOutline(AffineTransform.getTranslateInstance(x, y)));
    }

    static double width(String text, Font font) {
        return new TextLayout(text, font, EXACT).getAdvance();
    }
}
