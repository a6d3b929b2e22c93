package mmneat.analysis.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.AxesChartStyler;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.SeriesMarkers;

/**
 * A chart in the house style: white, few lines, large enough letters.
 *
 * <p>XChart draws axes and points. Curves and areas are drawn over it as one path each: XChart would draw every piece between two
 * points as a line of its own, which breaks dashes and makes an SVG of megabytes.
 */
final class Panel {

    /** A line, or without a stroke the area within. */
    private record Curve(double[] x, double[] y, Color color, BasicStroke stroke) {}

    private record Label(String text, double x, double y, Color color) {}

    private static final MethodStyle INVISIBLE = new MethodStyle(Color.WHITE, new float[] {}, SeriesMarkers.NONE);
    /** How far an axis goes beyond what is shown, as a share of it. */
    private static final double END_OF_AXIS = 0.004;

    private static final Font LABEL_FONT = new Font(Font.SANS_SERIF, Font.BOLD, 12);

    private final XYChart chart;
    private final List<Curve> curves = new ArrayList<>();
    private final List<Label> labels = new ArrayList<>();
    private double low = Double.POSITIVE_INFINITY;
    private double high = Double.NEGATIVE_INFINITY;

    Panel(String title, String xTitle, String yTitle) {
        chart = new XYChartBuilder()
                .title(title)
                .xAxisTitle(xTitle)
                .yAxisTitle(yTitle)
                .build();
        XYStyler style = chart.getStyler();
        style.setBaseFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        style.setChartTitleFont(new Font(Font.SANS_SERIF, Font.BOLD, 14));
        style.setChartTitleBoxVisible(false);
        style.setAxisTitleFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        style.setAxisTickLabelsFont(new Font(Font.SANS_SERIF, Font.PLAIN, 11));
        style.setChartBackgroundColor(Color.WHITE);
        style.setPlotBackgroundColor(Color.WHITE);
        style.setPlotBorderVisible(false);
        style.setPlotGridVerticalLinesVisible(false);
        style.setPlotGridLinesColor(new Color(0xe3, 0xe5, 0xea));
        style.setPlotGridLinesStroke(new BasicStroke(0.8f));
        style.setAxisTickMarksColor(new Color(0x80, 0x86, 0x92));
        style.setLegendVisible(false);
        // Room for the half of a label under the end of an axis.
        style.setChartPadding(16);
        style.setXAxisDecimalPattern("#,##0");
        style.setYAxisLabelAlignment(AxesChartStyler.TextAlignment.Right);
        style.setLocale(java.util.Locale.ROOT);
        style.setToolTipsEnabled(false);
        style.setPlotContentSize(1.0);
        style.setXAxisTickMarkSpacingHint(76);
        style.setYAxisTickMarkSpacingHint(44);
        style.setMarkerSize(8);
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
    void points(String name, double[] x, double[] y, MethodStyle style) {
        XYSeries series = chart.addSeries(name, x, y);
        series.setXYSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Scatter);
        series.setMarker(style.marker());
        series.setMarkerColor(style.color());
    }

    /** A text beside a place of the chart. */
    void label(String text, double x, double y, Color color) {
        labels.add(new Label(text, x, y, color));
    }

    /** The smallest value of all curves and bands. */
    double low() {
        return low;
    }

    /** The largest value of all curves and bands. */
    double high() {
        return high;
    }

    /** Sets the axes; to be called once, before painting. An axis without extent becomes 1 high. */
    void range(double left, double right, double bottom, double highest) {
        double top = highest > bottom ? highest : bottom + 1;
        if (chart.getSeriesMap().isEmpty()) {
            // XChart draws axes for its own series only, and ticks only if these have many values.
            points("axes", between(left, right), between(bottom, top), INVISIBLE);
        }
        // XChart labels no tick at the very end of an axis.
        double across = END_OF_AXIS * (right - left);
        double along = END_OF_AXIS * (top - bottom);
        chart.getStyler().setXAxisMin(left - across).setXAxisMax(right + across);
        chart.getStyler().setYAxisMin(bottom - along).setYAxisMax(top + along);
        chart.getStyler().setYAxisDecimalPattern(pattern(top - bottom));
    }

    /** As many decimals as tell a tenth of the range apart. */
    private static String pattern(double range) {
        int decimals = (int) Math.max(0, Math.ceil(1 - Math.log10(range)));
        return decimals == 0 ? "#,##0" : "#,##0." + "0".repeat(decimals);
    }

    void paint(Graphics2D graphics, int width, int height) {
        chart.paint(graphics, width, height);
        for (Curve curve : curves) {
            Path2D path = new Path2D.Double();
            for (int i = 0; i < curve.x.length; i++) {
                double x = round(chart.getScreenXFromChart(curve.x[i]));
                double y = round(chart.getScreenYFromChart(curve.y[i]));
                if (i == 0) {
                    path.moveTo(x, y);
                } else {
                    path.lineTo(x, y);
                }
            }
            graphics.setColor(curve.color);
            if (curve.stroke == null) {
                path.closePath();
                graphics.fill(path);
            } else {
                graphics.setStroke(curve.stroke);
                graphics.draw(path);
            }
        }
        for (Label label : labels) {
            graphics.setColor(label.color);
            Letters.draw(
                    graphics,
                    label.text,
                    LABEL_FONT,
                    chart.getScreenXFromChart(label.x),
                    chart.getScreenYFromChart(label.y) + LABEL_FONT.getSize() / 3.0);
        }
    }

    private static double[] between(double from, double to) {
        double[] values = new double[101];
        for (int i = 0; i < values.length; i++) {
            // Unevenly: XChart would make even steps its ticks, however odd the numbers.
            values[i] = from + (to - from) * Math.pow(i / (values.length - 1.0), 1.3);
        }
        return values;
    }

    /** A twentieth of a point is finer than any print. */
    private static double round(double points) {
        return Math.round(20 * points) / 20.0;
    }

    private void extend(double[] values) {
        for (double value : values) {
            low = Math.min(low, value);
            high = Math.max(high, value);
        }
    }
}
