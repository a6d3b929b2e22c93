package mmneat.analysis.figures;

import de.erichseifert.vectorgraphics2d.Document;
import de.erichseifert.vectorgraphics2d.Processors;
import de.erichseifert.vectorgraphics2d.VectorGraphics2D;
import de.erichseifert.vectorgraphics2d.util.PageSize;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import javax.imageio.ImageIO;

/** A figure of one or more panels side by side and below each other, all of one size, with one legend. */
public final class Figure {

    /** Most panels in a row of a {@link #grid}. */
    private static final int COLUMNS = 3;

    /** Pixels per point of the PNG: sharp in print at the width of a page. */
    private static final int PNG_SCALE = 3;

    private final String name;
    private final String caption;
    private final List<Panel> panels;
    private final List<Key> keys;
    private final int columns;
    private final int panelWidth;
    private final int panelHeight;

    /**
     * A figure.
     *
     * @param name file name without its ending
     * @param caption what it shows, in a sentence or two
     * @param panels the panels, row by row
     * @param keys the legend, may be empty
     * @param columns panels per row
     * @param panelWidth width of a panel in points
     * @param panelHeight height of a panel in points
     */
    Figure(
            String name,
            String caption,
            List<Panel> panels,
            List<Key> keys,
            int columns,
            int panelWidth,
            int panelHeight) {
        this.name = name;
        this.caption = caption;
        this.panels = List.copyOf(panels);
        this.keys = List.copyOf(keys);
        this.columns = columns;
        this.panelWidth = panelWidth;
        this.panelHeight = panelHeight;
    }

    /** Panels in a row of a {@link #grid}: four stand two and two. */
    static int columns(int panels) {
        return panels == 4 ? 2 : Math.min(COLUMNS, panels);
    }

    /** A figure of small panels in rows, or of one large panel. */
    static Figure grid(String name, String caption, List<Panel> panels, List<Key> keys) {
        return panels.size() == 1
                ? new Figure(name, caption, panels, keys, 1, 620, 420)
                : new Figure(name, caption, panels, keys, columns(panels.size()), 360, 280);
    }

    /** File name without its ending. */
    public String name() {
        return name;
    }

    /** What it shows, in a sentence or two. */
    public String caption() {
        return caption;
    }

    private int width() {
        return columns * panelWidth;
    }

    private int height() {
        return (panels.size() + columns - 1) / columns * panelHeight + (keys.isEmpty() ? 0 : Key.HEIGHT);
    }

    /** The figure as an SVG document. */
    public String svg() {
        VectorGraphics2D graphics = new VectorGraphics2D();
        paint(graphics);
        Document document =
                Processors.get("svg").getDocument(graphics.getCommands(), new PageSize(0, 0, width(), height()));
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            document.writeTo(bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toString(StandardCharsets.UTF_8);
    }

    /** The figure as a PNG file, three pixels per point. */
    public byte[] png() {
        BufferedImage image = new BufferedImage(PNG_SCALE * width(), PNG_SCALE * height(), BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.scale(PNG_SCALE, PNG_SCALE);
        paint(graphics);
        graphics.dispose();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, "png", bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    private void paint(Graphics2D graphics) {
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, width(), height());
        for (int i = 0; i < panels.size(); i++) {
            int x = i % columns * panelWidth;
            int y = i / columns * panelHeight;
            graphics.translate(x, y);
            panels.get(i).paint(graphics, panelWidth, panelHeight);
            graphics.translate(-x, -y);
        }
        if (!keys.isEmpty()) {
            int y = height() - Key.HEIGHT;
            graphics.translate(0, y);
            Key.paint(graphics, keys, width());
            graphics.translate(0, -y);
        }
    }
}
