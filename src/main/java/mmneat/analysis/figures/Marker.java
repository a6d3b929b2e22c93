package mmneat.analysis.figures;

import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;

/** The shape of a point in a scatter plot, filled. The names of the constants say the shapes. */
enum Marker {
    CIRCLE,
    SQUARE(-1, -1, 1, -1, 1, 1, -1, 1),
    DIAMOND(0, -1.3, 1.3, 0, 0, 1.3, -1.3, 0),
    TRIANGLE_UP(0, -1.2, 1.2, 1, -1.2, 1),
    TRIANGLE_DOWN(0, 1.2, 1.2, -1, -1.2, -1),
    PLUS(
            -0.4, -1.3, 0.4, -1.3, 0.4, -0.4, 1.3, -0.4, 1.3, 0.4, 0.4, 0.4, 0.4, 1.3, -0.4, 1.3, -0.4, 0.4, -1.3, 0.4,
            -1.3, -0.4, -0.4, -0.4),
    STAR(
            0, -1.5, 0.35, -0.49, 1.43, -0.46, 0.57, 0.19, 0.88, 1.21, 0, 0.6, -0.88, 1.21, -0.57, 0.19, -1.43, -0.46,
            -0.35, -0.49),
    PENTAGON(0, -1.25, 1.19, -0.39, 0.73, 1.01, -0.73, 1.01, -1.19, -0.39),
    BAR(-1.5, -0.5, 1.5, -0.5, 1.5, 0.5, -1.5, 0.5),
    CROSS(
            -1.2, -0.7, -0.7, -1.2, 0, -0.5, 0.7, -1.2, 1.2, -0.7, 0.5, 0, 1.2, 0.7, 0.7, 1.2, 0, 0.5, -0.7, 1.2, -1.2,
            0.7, -0.5, 0);

    private static final double RADIUS = 3.5;

    /** Corners x, y in radii from the middle; none for a circle. */
    private final double[] corners;

    Marker(double... corners) {
        this.corners = corners;
    }

    /** The marker of a point at this place. */
    Shape at(double x, double y) {
        if (corners.length == 0) {
            return new Ellipse2D.Double(x - RADIUS, y - RADIUS, 2 * RADIUS, 2 * RADIUS);
        }
        Path2D outline = new Path2D.Double();
        outline.moveTo(x + RADIUS * corners[0], y + RADIUS * corners[1]);
        for (int i = 2; i < corners.length; i += 2) {
            outline.lineTo(x + RADIUS * corners[i], y + RADIUS * corners[i + 1]);
        }
        outline.closePath();
        return outline;
    }
}
