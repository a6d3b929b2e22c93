package mmneat.neat.io;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The layout of a drawing: inputs in the bottom row, hidden neurons in rows by their distance from the inputs in links,
 * outputs on top in one box per module. Coordinates are in pixels, y downward.
 */
final class NetworkPlan {

    static final double MARGIN = 24;
    private static final double TOP = 64;
    private static final double ROW = 105;
    private static final double INPUT_SPACING = 24;
    private static final double OUTPUT_SPACING = 34;
    private static final double BOX_GAP = 34;
    private static final double BOX_PADDING = 18;
    private static final double BOX_HEIGHT = 42;
    private static final double LEGEND_WIDTH = 610;
    /** Width of a letter of an input's label. */
    private static final double LETTER = 6.4;

    private final NetworkGraph graph;
    private final double[] x;
    private final double[] y;
    private final List<Box> modules = new ArrayList<>();
    private double width;
    private double height;

    /** The frame of a module's outputs. */
    record Box(int module, double left, double top, double width, double height) {}

    private NetworkPlan(NetworkGraph graph) {
        this.graph = graph;
        this.x = new double[graph.neurons().size()];
        this.y = new double[graph.neurons().size()];
    }

    static NetworkPlan of(NetworkGraph graph) {
        NetworkPlan plan = new NetworkPlan(graph);
        List<Integer> inputs = plan.positions(NetworkGraph.Role.INPUT);
        List<List<Integer>> layers = plan.hiddenLayers();
        double inputsY = TOP + ROW * (layers.size() + 1.5);
        plan.width = plan.widthFor(inputs.size(), layers);
        plan.placeRow(inputs, inputsY);
        plan.placeOutputs();
        for (int layer = 0; layer < layers.size(); layer++) {
            plan.placeHidden(layers.get(layer), inputsY - ROW * (layer + 1));
        }
        int longestLabel = inputs.stream()
                .mapToInt(i -> graph.neurons().get(i).label().length())
                .max()
                .orElse(0);
        plan.height = inputsY + 24 + LETTER * longestLabel + 2 * MARGIN;
        return plan;
    }

    double x(int neuron) {
        return x[neuron];
    }

    double y(int neuron) {
        return y[neuron];
    }

    double width() {
        return width;
    }

    double height() {
        return height;
    }

    List<Box> modules() {
        return modules;
    }

    private List<Integer> positions(NetworkGraph.Role role) {
        List<Integer> positions = new ArrayList<>();
        for (int i = 0; i < graph.neurons().size(); i++) {
            if (graph.neurons().get(i).role() == role) {
                positions.add(i);
            }
        }
        return positions;
    }

    private boolean isOutput(int neuron) {
        return graph.neurons().get(neuron).module() >= 0;
    }

    /**
     * Returns hidden neurons by the length of the longest path of forward links from an input. Links are visited in
     * activation order, so one pass is enough.
     */
    private List<List<Integer>> hiddenLayers() {
        int[] depth = new int[graph.neurons().size()];
        List<NetworkGraph.Link> forward = graph.links().stream()
                .filter(link -> !link.isRecurrent())
                .sorted(Comparator.comparingInt(NetworkGraph.Link::source))
                .toList();
        for (NetworkGraph.Link link : forward) {
            depth[link.target()] = Math.max(depth[link.target()], depth[link.source()] + 1);
        }
        List<List<Integer>> layers = new ArrayList<>();
        for (int neuron : positions(NetworkGraph.Role.HIDDEN)) {
            int layer = Math.max(0, depth[neuron] - 1);
            while (layers.size() <= layer) {
                layers.add(new ArrayList<>());
            }
            layers.get(layer).add(neuron);
        }
        layers.removeIf(List::isEmpty);
        return layers;
    }

    private double widthFor(int inputs, List<List<Integer>> layers) {
        int widestLayer = layers.stream().mapToInt(List::size).max().orElse(0);
        return Math.max(
                2 * MARGIN + Math.max(INPUT_SPACING * inputs, OUTPUT_SPACING * widestLayer),
                Math.max(2 * MARGIN + outputsWidth(), LEGEND_WIDTH + 2 * MARGIN));
    }

    private double outputsWidth() {
        double width = (graph.modules().size() - 1) * BOX_GAP;
        for (int module = 0; module < graph.modules().size(); module++) {
            width += boxWidth(module);
        }
        return width;
    }

    /** Width needed for the outputs of a module and for its name. */
    private double boxWidth(int module) {
        return Math.max(
                (outputsOf(module) - 1) * OUTPUT_SPACING + 2 * BOX_PADDING,
                LETTER * graph.modules().get(module).length());
    }

    private long outputsOf(int module) {
        return graph.neurons().stream()
                .filter(neuron -> neuron.module() == module)
                .count();
    }

    private void placeRow(List<Integer> row, double rowY) {
        for (int i = 0; i < row.size(); i++) {
            x[row.get(i)] = MARGIN + (width - 2 * MARGIN) * (i + 0.5) / row.size();
            y[row.get(i)] = rowY;
        }
    }

    private void placeOutputs() {
        double left = (width - outputsWidth()) / 2;
        int neuron = 0;
        while (neuron < x.length && !isOutput(neuron)) {
            neuron++;
        }
        for (int module = 0; module < graph.modules().size(); module++) {
            double boxWidth = boxWidth(module);
            modules.add(new Box(module, left, TOP, boxWidth, BOX_HEIGHT));
            long outputs = outputsOf(module);
            for (int output = 0; output < outputs; output++) {
                x[neuron] = left + boxWidth / 2 + (output - (outputs - 1) / 2.0) * OUTPUT_SPACING;
                y[neuron] = TOP + BOX_HEIGHT / 2;
                neuron++;
            }
            left += boxWidth + BOX_GAP;
        }
    }

    /** Places a layer at equal distances, ordered by the mean position of the linked neurons. */
    private void placeHidden(List<Integer> layer, double rowY) {
        List<Integer> ordered = new ArrayList<>(layer);
        double[] places = meanPlacesOfNeighbours();
        ordered.sort(Comparator.comparingDouble(neuron -> places[neuron]));
        placeRow(ordered, rowY);
        // Slightly staggered, so that links within a row can be distinguished.
        for (int i = 0; i < ordered.size(); i++) {
            y[ordered.get(i)] += i % 2 == 0 ? -9 : 9;
        }
    }

    /** Returns per neuron the mean position of its linked neurons that are already placed. */
    private double[] meanPlacesOfNeighbours() {
        double[] sum = new double[x.length];
        int[] count = new int[x.length];
        for (NetworkGraph.Link link : graph.links()) {
            if (link.source() != link.target()) {
                addPlace(link.source(), link.target(), sum, count);
                addPlace(link.target(), link.source(), sum, count);
            }
        }
        for (int neuron = 0; neuron < sum.length; neuron++) {
            sum[neuron] = count[neuron] == 0 ? width / 2 : sum[neuron] / count[neuron];
        }
        return sum;
    }

    private void addPlace(int neuron, int neighbour, double[] sum, int[] count) {
        if (x[neighbour] > 0) {
            sum[neuron] += x[neighbour];
            count[neuron]++;
        }
    }
}
