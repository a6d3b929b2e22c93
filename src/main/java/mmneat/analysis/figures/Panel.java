package mmneat.analysis.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import mmneat.analysis.figures.Canvas.Align;
import org.jspecify.annotations.Nullable;

/** A chart with two axes, curves, areas, points and labels. */
final class Panel {

    /** A line through points; if the stroke is null, the points are the corners of a filled polygon. */
    private record Curve(
            double[] x, double[] y, Color color, @Nullable BasicStroke stroke) {}

    private record Points(double[] x, double[] y, MethodStyle style) {}

    /** The name of a curve, beside its right end. */
    private record Label(String text, double y, Color color) {}

    private static final Font TITLE_FONT = new Font(Font.SANS_SERIF, Font.BOLD, 14);
    private static final Font AXIS_FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);
    private static final Font TICK_FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
    private static final Font LABEL_FONT = new Font(Font.SANS_SERIF, Font.BOLD, 12);
    private static final Color GRID = new Color(0xe3, 0xe5, 0xea);
    private static final Color TICKS = new Color(0x80, 0x86, 0x92);
    private static final Color TEXT = new Color(0x22, 0x25, 0x2c);
    private static final BasicStroke THIN = new BasicStroke(0.8f);

    private static final int MARGIN = 16;
    private static final int TITLE_HEIGHT = 24;
    private static final int TICK_LENGTH = 4;
    private static final int TICK_GAP = 4;
    private static final int LABEL_GAP = 7;
    private static final int POINTS_PER_TICK_ACROSS = 76;
    private static final int POINTS_PER_TICK_UP = 44;

    private final String title;
    private final String xTitle;
    private final String yTitle;
    private final List<Curve> curves = new ArrayList<>();
    private final List<Points> points = new ArrayList<>();
    private final List<Label> labels = new ArrayList<>();
    private double low = Double.POSITIVE_INFINITY;
    private double high = Double.NEGATIVE_INFINITY;
    private Axis across = new Axis(0, 1);
    private Axis up = new Axis(0, 1);

    Panel(String title, String xTitle, String yTitle) {
        this.title = title;
        this.xTitle = xTitle;
        this.yTitle = yTitle;
    }

    /** A curve over generations 0, 1, ... */
    void curve(double[] y, Color color, BasicStroke stroke) {
        double[] x = new double[y.length];
        for (int i = 0; i < x.length; i++) {
            x[i] = i;
        }
        curves.add(new Curve(x, y, color, stroke));
        extend(y);
    }

    /** The area between two curves over generations 0, 1, ... */
    void band(double[] lower, double[] upper, Color color) {
        int n = lower.length;
        double[] x = new double[2 * n];
        double[] y = new double[2 * n];
        for (int i = 0; i < n; i++) {
            x[i] = i;
            y[i] = upper[i];
            x[2 * n - 1 - i] = i;
            y[2 * n - 1 - i] = lower[i];
        }
        curves.add(new Curve(x, y, color, null));
        extend(y);
    }

    /** Points of a scatter plot. */
    void points(double[] x, double[] y, MethodStyle style) {
        points.add(new Points(x, y, style));
    }

    /** A text to the right of the chart, near the height of a value. */
    void label(String text, double y, Color color) {
        labels.add(new Label(text, y, color));
    }

    /** The smallest value of all curves and bands. */
    double low() {
        return low;
    }

    /** The largest value of all curves and bands. */
    double high() {
        return high;
    }

    /** Sets the axes; a range without extent is widened. */
    void range(double left, double right, double bottom, double top) {
        across = Axis.of(left, right);
        up = Axis.of(bottom, top);
    }

    /**
     * Draws the panel below and right of the origin.
     *
     * @param width in points
     * @param height in points
     * @param withYTitle whether the title of the vertical axis is written
     */
    void paint(Canvas canvas, int width, int height, boolean withYTitle) {
        int rows = Math.max(2, height / POINTS_PER_TICK_UP);
        List<Double> ticksUp = up.ticks(rows);
        double widest = ticksUp.stream()
                .mapToDouble(tick -> TextWidth.of(up.label(tick, rows), TICK_FONT))
                .max()
                .orElse(0);
        double left = MARGIN + (!withYTitle ? 0 : AXIS_FONT.getSize() + 2 * TICK_GAP) + widest + TICK_GAP + TICK_LENGTH;
        double top = MARGIN + (title.isEmpty() ? 0 : TITLE_HEIGHT);
        double bottom = height - MARGIN - AXIS_FONT.getSize() - TICK_FONT.getSize() - 2 * TICK_GAP - TICK_LENGTH;
        double labelWidth = labels.stream()
                .mapToDouble(label -> TextWidth.of(label.text, LABEL_FONT) + LABEL_GAP)
                .max()
                .orElse(0);
        Frame frame = new Frame(left, top, width - MARGIN - labelWidth, bottom);
        canvas.text(title, (frame.left + frame.right) / 2, MARGIN + 10, TITLE_FONT, TEXT, Align.MIDDLE);
        canvas.text(xTitle, (frame.left + frame.right) / 2, height - MARGIN, AXIS_FONT, TEXT, Align.MIDDLE);
        if (withYTitle) {
            canvas.textUpwards(yTitle, MARGIN + AXIS_FONT.getSize() - 2, (top + bottom) / 2, AXIS_FONT, TEXT);
        }
        paintAxes(canvas, frame, ticksUp, rows);
        curves.forEach(curve -> paint(canvas, frame, curve));
        for (Points cloud : points) {
            for (int i = 0; i < cloud.x.length; i++) {
                if (Double.isFinite(cloud.x[i]) && Double.isFinite(cloud.y[i])) {
                    canvas.fill(cloud.style.marker().at(frame.x(cloud.x[i]), frame.y(cloud.y[i])), cloud.style.color());
                }
            }
        }
        paintLabels(canvas, frame);
    }

    private void paintLabels(Canvas canvas, Frame frame) {
        double[] places =
                spread(labels.stream().mapToDouble(label -> frame.y(label.y)).toArray(), LABEL_FONT.getSize() + 2);
        for (int i = 0; i < places.length; i++) {
            Label label = labels.get(i);
            double base = places[i] + LABEL_FONT.getSize() / 3.0;
            canvas.text(label.text, frame.right + LABEL_GAP, base, LABEL_FONT, label.color, Align.START);
        }
    }

    /** Places near the given ones with at least {@code gap} points between every two. */
    private static double[] spread(double[] wanted, double gap) {
        double[] places = wanted.clone();
        Integer[] order = IntStream.range(0, wanted.length).boxed().toArray(Integer[]::new);
        Arrays.sort(order, Comparator.comparingDouble(i -> wanted[i]));
        for (int round = 0; round < 200; round++) {
            for (int k = 1; k < order.length; k++) {
                double missing = gap - (places[order[k]] - places[order[k - 1]]);
                if (missing > 0) {
                    places[order[k]] += missing / 2;
                    places[order[k - 1]] -= missing / 2;
                }
            }
        }
        return places;
    }

    private void paintAxes(Canvas canvas, Frame frame, List<Double> ticksUp, int rows) {
        for (double tick : ticksUp) {
            double y = frame.y(tick);
            canvas.draw(new Line2D.Double(frame.left, y, frame.right, y), GRID, THIN);
            canvas.draw(new Line2D.Double(frame.left - TICK_LENGTH, y, frame.left, y), TICKS, THIN);
            double right = frame.left - TICK_LENGTH - TICK_GAP;
            canvas.text(up.label(tick, rows), right, y + TICK_FONT.getSize() / 3.0, TICK_FONT, TEXT, Align.END);
        }
        int fitting = Math.max(2, (int) (frame.right - frame.left) / POINTS_PER_TICK_ACROSS);
        // Generations are whole numbers.
        int columns = curves.isEmpty() ? fitting : (int) Math.max(1, Math.min(fitting, across.high() - across.low()));
        for (double tick : across.ticks(columns)) {
            double x = frame.x(tick);
            canvas.draw(new Line2D.Double(x, frame.bottom, x, frame.bottom + TICK_LENGTH), TICKS, THIN);
            double base = frame.bottom + TICK_LENGTH + TICK_GAP + TICK_FONT.getSize() - 2;
            canvas.text(across.label(tick, columns), x, base, TICK_FONT, TEXT, Align.MIDDLE);
        }
        canvas.draw(new Line2D.Double(frame.left, frame.bottom, frame.right, frame.bottom), TICKS, THIN);
        canvas.draw(new Line2D.Double(frame.left, frame.top, frame.left, frame.bottom), TICKS, THIN);
    }

    private static void paint(Canvas canvas, Frame frame, Curve curve) {
        Path2D path = new Path2D.Double();
        boolean isOpen = false;
        for (int i = 0; i < curve.x.length; i++) {
            if (!Double.isFinite(curve.y[i])) {
                // A curve has a gap where there is no number; an area goes on.
                isOpen = isOpen && curve.stroke == null;
                continue;
            }
            double x = frame.x(curve.x[i]);
            double y = frame.y(curve.y[i]);
            if (isOpen) {
                path.lineTo(x, y);
            } else {
                path.moveTo(x, y);
            }
            isOpen = true;
        }
        if (curve.stroke != null) {
            canvas.draw(path, curve.color, curve.stroke);
        } else if (isOpen) {
            path.closePath();
            canvas.fill(path, curve.color);
        }
    }

    /** The rectangle between the axes, in points, and the places of values in it. */
    private final class Frame {

        private final double left;
        private final double top;
        private final double right;
        private final double bottom;

        Frame(double left, double top, double right, double bottom) {
            this.left = left;
            this.top = top;
            this.right = right;
            this.bottom = bottom;
        }

        double x(double value) {
            return left + (right - left) * across.share(value);
        }

        double y(double value) {
            return bottom - (bottom - top) * up.share(value);
        }
    }

    private void extend(double[] values) {
        for (double value : values) {
            if (Double.isFinite(value)) {
                low = Math.min(low, value);
                high = Math.max(high, value);
            }
        }
    }
}
