package mmneat.analysis.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.List;

/**
 * How a method looks, the same in every figure. Colours are those of Okabe and Ito (2008), which colour-blind readers tell
 * apart; dashes and markers do the same without colour.
 *
 * @param color of lines and markers
 * @param dash lengths of dashes and gaps; empty for a solid line
 * @param marker of points
 */
record MethodStyle(Color color, float[] dash, Marker marker) {

    /** The paper's data, behind ours. */
    static final Color PAPER = new Color(0xa9, 0xae, 0xb8);

    private static final List<MethodStyle> OTHERS = List.of(
            new MethodStyle(new Color(0x00, 0x72, 0xb2), new float[] {}, Marker.CIRCLE),
            new MethodStyle(new Color(0xd5, 0x5e, 0x00), new float[] {9, 4}, Marker.SQUARE),
            new MethodStyle(new Color(0x00, 0x9e, 0x73), new float[] {2, 3}, Marker.DIAMOND),
            new MethodStyle(new Color(0xcc, 0x79, 0xa7), new float[] {9, 3, 2, 3}, Marker.TRIANGLE_UP));

    /** The style of a published method, or one of a few for others. */
    static MethodStyle of(String method, int place) {
        return switch (method) {
            case "1M" -> new MethodStyle(new Color(0x1a, 0x1a, 0x1a), new float[] {2, 3}, Marker.CROSS);
            case "2M" -> new MethodStyle(new Color(0x00, 0x72, 0xb2), new float[] {}, Marker.CIRCLE);
            case "3M" -> new MethodStyle(new Color(0xd5, 0x5e, 0x00), new float[] {12, 4}, Marker.SQUARE);
            case "MMD" -> new MethodStyle(new Color(0x00, 0x9e, 0x73), new float[] {12, 3, 2, 3}, Marker.DIAMOND);
            case "MT", "MT2" -> new MethodStyle(new Color(0xcc, 0x79, 0xa7), new float[] {6, 4}, Marker.TRIANGLE_UP);
            case "MT3" -> new MethodStyle(new Color(0x8a, 0x5a, 0x00), new float[] {4, 2, 1, 2}, Marker.TRIANGLE_DOWN);
            default -> OTHERS.get(place % OTHERS.size());
        };
    }

    BasicStroke stroke(float width) {
        return dash.length == 0
                ? new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND)
                : new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, dash, 0);
    }

    /** The colour as a light wash, for areas. */
    Color wash() {
        return new Color(mixed(color.getRed()), mixed(color.getGreen()), mixed(color.getBlue()));
    }

    private static int mixed(int channel) {
        return (int) Math.round(255 - 0.22 * (255 - channel));
    }
}
