package mmneat.analysis.figures;

import java.awt.Font;

/** Estimates of the width of text in a common sans-serif font. The font in which an SVG is shown later is not known. */
final class TextWidth {

    private static final String NARROW = "iljtfrI.,:;'|!()[] ";
    private static final String WIDE = "mwMW%@";

    private TextWidth() {}

    /** Width in points. */
    static double of(String text, Font font) {
        double ems = 0;
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            ems += NARROW.indexOf(c) >= 0 ? 0.31 : WIDE.indexOf(c) >= 0 ? 0.89 : Character.isUpperCase(c) ? 0.7 : 0.57;
        }
        return ems * font.getSize() * (font.isBold() ? 1.07 : 1);
    }
}
