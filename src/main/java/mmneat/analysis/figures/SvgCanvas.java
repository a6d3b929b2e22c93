package mmneat.analysis.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.geom.PathIterator;
import java.util.Locale;
import mmneat.analysis.Page;

/**
 * An SVG document. Text is written as text elements: it can be searched and copied, and writing it needs no installed
 * font.
 *
 * <p>Numbers are rounded to hundredths of a point.
 */
final class SvgCanvas implements Canvas {

    private static final String[] PATH_COMMANDS = {"M", "L", "Q", "C", "Z"};
    private static final int[] PATH_NUMBERS = {2, 2, 4, 6, 0};

    private final StringBuilder document = new StringBuilder();
    private double originX;
    private double originY;

    SvgCanvas(int width, int height) {
        document.append(String.format(
                Locale.ROOT,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %1$d %2$d\""
                        + " font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">%n",
                width,
                height));
    }

    /** The document with everything drawn so far. */
    String document() {
        return (document + "</svg>\n").replace("\r\n", "\n");
    }

    @Override
    public void fill(Shape shape, Color color) {
        document.append("<path d=\"").append(path(shape)).append("\" fill=\"").append(name(color));
        document.append("\"/>\n");
    }

    @Override
    public void draw(Shape shape, Color color, BasicStroke stroke) {
        document.append("<path d=\"")
                .append(path(shape))
                .append("\" fill=\"none\" stroke=\"")
                .append(name(color));
        document.append("\" stroke-width=\"").append(number(stroke.getLineWidth()));
        document.append("\" stroke-linejoin=\"round");
        if (stroke.getDashArray() != null) {
            document.append("\" stroke-dasharray=\"");
            for (float length : stroke.getDashArray()) {
                document.append(number(length)).append(' ');
            }
            document.setLength(document.length() - 1);
        }
        document.append("\"/>\n");
    }

    @Override
    public void text(String text, double x, double y, Font font, Color color, Align align) {
        document.append("<text x=\"")
                .append(number(originX + x))
                .append("\" y=\"")
                .append(number(originY + y));
        String anchor = align.name().toLowerCase(Locale.ROOT);
        document.append("\" text-anchor=\"").append(anchor).append('"');
        endText(text, font, color);
    }

    @Override
    public void textUpwards(String text, double x, double y, Font font, Color color) {
        document.append("<text transform=\"translate(")
                .append(number(originX + x))
                .append(' ');
        document.append(number(originY + y)).append(") rotate(-90)\" text-anchor=\"middle\"");
        endText(text, font, color);
    }

    private void endText(String text, Font font, Color color) {
        document.append(" font-size=\"").append(font.getSize());
        if (font.isBold()) {
            document.append("\" font-weight=\"bold");
        }
        document.append("\" fill=\"").append(name(color)).append("\">");
        document.append(Page.escape(text)).append("</text>\n");
    }

    @Override
    public void translate(double x, double y) {
        originX += x;
        originY += y;
    }

    private String path(Shape shape) {
        StringBuilder path = new StringBuilder();
        double[] numbers = new double[6];
        for (PathIterator part = shape.getPathIterator(null); !part.isDone(); part.next()) {
            int kind = part.currentSegment(numbers);
            path.append(PATH_COMMANDS[kind]);
            for (int i = 0; i < PATH_NUMBERS[kind]; i++) {
                path.append(i == 0 ? "" : " ").append(number(numbers[i] + (i % 2 == 0 ? originX : originY)));
            }
        }
        return path.toString();
    }

    private static String name(Color color) {
        return String.format(Locale.ROOT, "#%06x", color.getRGB() & 0xffffff);
    }

    private static String number(double points) {
        double rounded = Math.round(100 * points) / 100.0;
        return rounded == Math.rint(rounded) ? Long.toString((long) rounded) : Double.toString(rounded);
    }
}
