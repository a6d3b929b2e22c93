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

/** A figure of one or more panels of equal size in rows, with one legend below. */
public final class Figure {

    /** Maximum number of panels in a row of a {@link #grid}. */
    private static final int COLUMNS = 3;

    /** Width in points of the layout for narrow screens. */
    private static final int NARROW_WIDTH = 380;

    private final String name;
    private final String caption;
    private final List<Panel> panels;
    private final Legend legend;
    private final Layout wide;
    private final Layout narrow;

    /**
     * The arrangement of panels.
     *
     * @param columns panels per row
     * @param panelWidth width of a panel in points
     * @param panelHeight height of a panel in points
     */
    private record Layout(int columns, int panelWidth, int panelHeight) {

        int width() {
            return columns * panelWidth;
        }
    }

    private Figure(String name, String caption, List<Panel> panels, List<LegendEntry> legend, Layout wide) {
        this.name = name;
        this.caption = caption;
        this.panels = List.copyOf(panels);
        this.legend = new Legend(legend);
        this.wide = wide;
        narrow = new Layout(1, NARROW_WIDTH, panels.size() == 1 ? 340 : 260);
    }

    /** Panels in a row of a {@link #grid}: at most three; four panels form two rows of two. */
    private static int columns(int panels) {
        return panels == 4 ? 2 : Math.min(COLUMNS, panels);
    }

    /**
     * A figure of one large panel.
     *
     * @param name file name without its ending
     * @param caption one or two sentences that say what the figure shows
     * @param legend entries of the legend, may be empty
     */
    static Figure single(String name, String caption, Panel panel, List<LegendEntry> legend) {
        return new Figure(name, caption, List.of(panel), legend, new Layout(1, 780, 460));
    }

    /**
     * A figure of small panels in rows; a single panel is larger.
     *
     * @param name file name without its ending
     * @param caption one or two sentences that say what the figure shows
     * @param panels the panels, row by row
     * @param legend entries of the legend, may be empty
     */
    static Figure grid(String name, String caption, List<Panel> panels, List<LegendEntry> legend) {
        return new Figure(
                name,
                caption,
                panels,
                legend,
                panels.size() == 1 ? new Layout(1, 620, 420) : new Layout(columns(panels.size()), 360, 280));
    }

    /** File name without its ending. */
    public String name() {
        return name;
    }

    /** One or two sentences that say what the figure shows. */
    public String caption() {
        return caption;
    }

    private int height(Layout layout) {
        int rows = (panels.size() + layout.columns - 1) / layout.columns;
        return rows * layout.panelHeight + legend.height(layout.width());
    }

    /** The figure as an SVG document. */
    public String svg() {
        return svg(wide);
    }

    /** The figure as an SVG document for narrow screens: its panels below each other, 380 points wide. */
    public String narrowSvg() {
        return svg(narrow);
    }

    private String svg(Layout layout) {
        SvgCanvas canvas = new SvgCanvas(layout.width(), height(layout));
        paint(canvas, layout);
        return canvas.document();
    }

    /** The figure as a PNG file, three pixels per point; empty if this machine has no font for its text. */
    public Optional<byte[]> png() {
        if (!MachineFonts.areAvailable()) {
            return Optional.empty();
        }
        RasterCanvas canvas = new RasterCanvas(wide.width(), height(wide));
        paint(canvas, wide);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            ImageIO.write(canvas.image(), "png", bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return Optional.of(bytes.toByteArray());
    }

    private void paint(Canvas canvas, Layout layout) {
        int height = height(layout);
        canvas.fill(new Rectangle2D.Double(0, 0, layout.width(), height), Color.WHITE);
        for (int i = 0; i < panels.size(); i++) {
            int x = i % layout.columns * layout.panelWidth;
            int y = i / layout.columns * layout.panelHeight;
            canvas.translate(x, y);
            panels.get(i).paint(canvas, layout.panelWidth, layout.panelHeight, x == 0);
            canvas.translate(-x, -y);
        }
        int top = height - legend.height(layout.width());
        canvas.translate(0, top);
        legend.paint(canvas, layout.width());
        canvas.translate(0, -top);
    }
}
