package mmneat.analysis.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.List;
import java.util.Optional;
import mmneat.analysis.results.Experiment;

/**
 * The colour, dash pattern and marker of a method, the same in every figure. The colours are those of Okabe and Ito
 * (2008), which colour-blind readers can distinguish; dash patterns and markers distinguish methods without colour.
 *
 * @param color of lines and markers
 * @param dash lengths of dashes and gaps; empty for a solid line
 * @param marker of points
 */
record MethodStyle(Color color, float[] dash, Marker marker) {

    /** The colour of the paper's data. */
    static final Color PAPER = new Color(0xa9, 0xae, 0xb8);

    /** The colour of the paper's lines over areas, which can be as light as {@link #PAPER}. */
    static final Color PAPER_ON_AREA = new Color(0x75, 0x7b, 0x87);

    /** Styles of variants of methods and of other experiments. None of them is the style of a published method. */
    private static final List<MethodStyle> OTHERS = List.of(
            new MethodStyle(new Color(0xe6, 0x9f, 0x00), new float[] {9, 3, 3, 3}, Marker.PLUS),
            new MethodStyle(new Color(0x56, 0xb4, 0xe9), new float[] {5, 2}, Marker.STAR),
            new MethodStyle(new Color(0x88, 0x22, 0x55), new float[] {14, 5, 2, 5}, Marker.PENTAGON),
            new MethodStyle(new Color(0x99, 0x99, 0x33), new float[] {3, 5}, Marker.BAR));

    /**
     * The style of an experiment in a figure: the style of its method if that is published, else the next of {@link
     * #OTHERS}.
     *
     * @param experiments the experiments of the figure
     * @param place index of the experiment among them
     */
    static MethodStyle of(List<Experiment> experiments, int place) {
        Experiment experiment = experiments.get(place);
        return published(experiment)
                .orElseGet(() -> OTHERS.get((int) (experiments.subList(0, place).stream()
                                .filter(earlier -> published(earlier).isEmpty())
                                .count()
                        % OTHERS.size())));
    }

    private static Optional<MethodStyle> published(Experiment experiment) {
        return experiment.isVariant() ? Optional.empty() : ofMethod(experiment.method());
    }

    private static Optional<MethodStyle> ofMethod(String method) {
        return Optional.ofNullable(
                switch (method) {
                    case "1M" -> new MethodStyle(new Color(0x1a, 0x1a, 0x1a), new float[] {2, 3}, Marker.CROSS);
                    case "2M" -> new MethodStyle(new Color(0x00, 0x72, 0xb2), new float[] {}, Marker.CIRCLE);
                    case "3M" -> new MethodStyle(new Color(0xd5, 0x5e, 0x00), new float[] {12, 4}, Marker.SQUARE);
                    case "MMD" ->
                        new MethodStyle(new Color(0x00, 0x9e, 0x73), new float[] {12, 3, 2, 3}, Marker.DIAMOND);
                    case "MT", "MT2" ->
                        new MethodStyle(new Color(0xcc, 0x79, 0xa7), new float[] {6, 4}, Marker.TRIANGLE_UP);
                    case "MT3" ->
                        new MethodStyle(new Color(0x8a, 0x5a, 0x00), new float[] {4, 2, 1, 2}, Marker.TRIANGLE_DOWN);
                    default -> null;
                });
    }

    BasicStroke stroke(float width) {
        return dash.length == 0
                ? new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND)
                : new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, dash, 0);
    }

    /** The light tint of the colour that fills areas. */
    Color areaColor() {
        return new Color(mixed(color.getRed()), mixed(color.getGreen()), mixed(color.getBlue()));
    }

    private static int mixed(int channel) {
        return (int) Math.round(255 - 0.22 * (255 - channel));
    }
}
