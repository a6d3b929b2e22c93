package mmneat.analysis.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;

/**
 * A drawing surface for shapes and text: an SVG document or a raster image. Coordinates are in points; the origin is at
 * the top left.
 */
interface Canvas {

    /** The point of a text's baseline that is placed at the given coordinates. */
    enum Align {
        /** The left end. */
        START,
        /** The middle. */
        MIDDLE,
        /** The right end. */
        END
    }

    /** Fills a shape. */
    void fill(Shape shape, Color color);

    /** Draws the outline of a shape. */
    void draw(Shape shape, Color color, BasicStroke stroke);

    /**
     * Writes a line of text.
     *
     * @param x horizontal coordinate of the point of the baseline that {@code align} names
     * @param y vertical coordinate of the baseline
     */
    void text(String text, double x, double y, Font font, Color color, Align align);

    /** Writes a line of text that runs upwards, with the middle of its baseline at the given coordinates. */
    void textUpwards(String text, double x, double y, Font font, Color color);

    /** Moves the origin of everything drawn afterwards. */
    void translate(double x, double y);
}
