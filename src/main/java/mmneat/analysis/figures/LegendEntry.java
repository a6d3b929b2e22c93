package mmneat.analysis.figures;

import java.util.List;

/**
 * An entry of a figure's legend.
 *
 * @param text meaning of the swatches
 * @param swatches one for each way in which the figure draws such data, for example one per method
 */
record LegendEntry(String text, List<Swatch> swatches) {

    LegendEntry {
        swatches = List.copyOf(swatches);
    }

    LegendEntry(String text, Swatch swatch) {
        this(text, List.of(swatch));
    }
}
