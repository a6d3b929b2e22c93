package mmneat.analysis.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;

/** A surface for shapes and text, in points, the origin at the top left: an SVG document or a raster picture. */
interface Canvas {

    /** Which point of a text's base line stands at the given place. */
    enum Align {
        START,
        MIDDLE,
        END
    }

    /** Fills a shape. */
    void fill(Shape shape, Color color);

    /** Draws the outline of a shape. */
    void draw(Shape shape, Color color, BasicStroke stroke);

    /**
     * Writes a line of text.
     *
     * @param x horizontal place of the point of the base line that {@code align} names
     * @param y vertical place of the base line
     */
    void text(String text, double x, double y, Font font, Color color, Align align);

    /** Writes a line of text that reads upwards; the middle of its base line stands at the given place. */
    void textUpwards(String text, double x, double y, Font font, Color color);

    /** Moves the origin of everything drawn afterwards. */
    void translate(double x, double y);
}
