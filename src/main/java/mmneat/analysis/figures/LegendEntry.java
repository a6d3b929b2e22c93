package mmneat.analysis.figures;

import java.util.List;

/**
 * An entry of a figure's legend.
 *
 * @param text the meaning, for example "quartiles"
 * @param swatches samples of the lines, areas or points with this meaning, beside the text: for example, if each method
 *     draws its quartiles as an area in another colour, one area per method
 */
record LegendEntry(String text, List<Swatch> swatches) {

    LegendEntry {
        swatches = List.copyOf(swatches);
    }

    LegendEntry(String text, Swatch swatch) {
        this(text, List.of(swatch));
    }
}
