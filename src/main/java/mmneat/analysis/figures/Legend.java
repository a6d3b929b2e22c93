package mmneat.analysis.figures;

import java.awt.Color;
import java.awt.Font;
import java.util.ArrayList;
import java.util.List;

/** The legend of a figure: entries side by side, in as many centred rows as they need. */
final class Legend {

    private static final int ROW_HEIGHT = 22;
    private static final int MARGIN = 8;
    private static final int SWATCH_GAP = 4;
    private static final int TEXT_GAP = 8;
    private static final int ENTRY_GAP = 26;
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);

    private final List<LegendEntry> entries;

    /** A legend; without entries it has no height. */
    Legend(List<LegendEntry> entries) {
        this.entries = List.copyOf(entries);
    }

    /** Height in points in a figure of this width. */
    int height(int width) {
        return entries.isEmpty() ? 0 : MARGIN + ROW_HEIGHT * rows(width).size();
    }

    /** Draws the legend below the origin, centred in this width. */
    void paint(Canvas canvas, int width) {
        double middle = ROW_HEIGHT / 2.0;
        for (List<LegendEntry> row : rows(width)) {
            double x = (width - width(row)) / 2;
            for (LegendEntry entry : row) {
                paint(canvas, entry, x, middle);
                x += width(entry) + ENTRY_GAP;
            }
            middle += ROW_HEIGHT;
        }
    }

    private static void paint(Canvas canvas, LegendEntry entry, double left, double middle) {
        double x = left;
        for (Swatch swatch : entry.swatches()) {
            swatch.paint(canvas, x, middle);
            x += swatch.width() + SWATCH_GAP;
        }
        canvas.text(entry.text(), x - SWATCH_GAP + TEXT_GAP, middle + 4, FONT, Color.BLACK, Canvas.Align.START);
    }

    private List<List<LegendEntry>> rows(int width) {
        List<List<LegendEntry>> rows = new ArrayList<>();
        for (LegendEntry entry : entries) {
            boolean fits = !rows.isEmpty()
                    && width(rows.get(rows.size() - 1)) + ENTRY_GAP + width(entry) <= width - 2 * MARGIN;
            if (!fits) {
                rows.add(new ArrayList<>());
            }
            rows.get(rows.size() - 1).add(entry);
        }
        return rows;
    }

    private static double width(List<LegendEntry> row) {
        return row.stream().mapToDouble(Legend::width).sum() + ENTRY_GAP * (row.size() - 1);
    }

    private static double width(LegendEntry entry) {
        double swatches = entry.swatches().stream().mapToDouble(Swatch::width).sum();
        return swatches + SWATCH_GAP * (entry.swatches().size() - 1) + TEXT_GAP + TextWidth.of(entry.text(), FONT);
    }
}
