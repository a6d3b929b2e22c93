package mmneat.analysis.figures;

import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import pacman.game.MachineFonts;

/** A figure of one or more panels side by side and below each other, all of one size, with one legend. */
public final class Figure {

    /** Most panels in a row of a {@link #grid}. */
    private static final int COLUMNS = 3;

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
        SvgCanvas canvas = new SvgCanvas(width(), height());
        paint(canvas);
        return canvas.document();
    }

    /** The figure as a PNG file, three pixels per point; empty if this machine has no font to write its text with. */
    public Optional<byte[]> png() {
        if (!MachineFonts.areAvailable()) {
            return Optional.empty();
        }
        RasterCanvas canvas = new RasterCanvas(width(), height());
        paint(canvas);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            ImageIO.write(canvas.image(), "png", bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return Optional.of(bytes.toByteArray());
    }

    private void paint(Canvas canvas) {
        canvas.fill(new Rectangle2D.Double(0, 0, width(), height()), Color.WHITE);
        for (int i = 0; i < panels.size(); i++) {
            int x = i % columns * panelWidth;
            int y = i / columns * panelHeight;
            canvas.translate(x, y);
            panels.get(i).paint(canvas, panelWidth, panelHeight);
            canvas.translate(-x, -y);
        }
        if (!keys.isEmpty()) {
            int y = height() - Key.HEIGHT;
            canvas.translate(0, y);
            Key.paint(canvas, keys, width());
            canvas.translate(0, -y);
        }
    }
}
