package mmneat.analysis.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;

/** A sample in a legend that looks exactly like the data: a piece of a line, of an area, or one point. */
sealed interface Swatch {

    /** Width in points. */
    double width();

    /** Draws the swatch with its left end at {@code x} and its middle at height {@code middle}, in points. */
    void paint(Canvas canvas, double x, double middle);

    /** A piece of a curve. */
    record Line(Color color, BasicStroke stroke) implements Swatch {

        @Override
        public double width() {
            return 28;
        }

        @Override
        public void paint(Canvas canvas, double x, double middle) {
            canvas.draw(new Line2D.Double(x, middle, x + width(), middle), color, stroke);
        }
    }

    /** A piece of an area. */
    record Area(Color color) implements Swatch {

        @Override
        public double width() {
            return 20;
        }

        @Override
        public void paint(Canvas canvas, double x, double middle) {
            canvas.fill(new Rectangle2D.Double(x, middle - 6, width(), 12), color);
        }
    }

    /** A point of a scatter plot. */
    record Point(Marker marker, Color color) implements Swatch {

        @Override
        public double width() {
            return 12;
        }

        @Override
        public void paint(Canvas canvas, double x, double middle) {
            canvas.fill(marker.at(x + width() / 2, middle), color);
        }
    }
}
