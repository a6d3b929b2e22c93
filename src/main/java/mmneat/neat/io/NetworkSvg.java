package mmneat.neat.io;

import java.io.StringWriter;
import java.util.Locale;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import mmneat.neat.Genotype;

/**
 * Draws a network as SVG, in the manner of Figure 1 of Schrum and Miikkulainen 2016: inputs below, output modules in
 * boxes above, preference neurons grey. A link's colour shows the sign of its weight, its width the absolute weight.
 * Recurrent links are curved and dashed. Each neuron and link has a tooltip.
 */
public final class NetworkSvg {

    private static final double RADIUS = 8;
    /** Dark and light, so that they also differ in black and white. */
    private static final String POSITIVE = "#1f5a9e";

    private static final String NEGATIVE = "#ee6a4d";

    private final XMLStreamWriter svg;
    private final NetworkGraph graph;
    private final NetworkPlan plan;

    private NetworkSvg(XMLStreamWriter svg, NetworkGraph graph, NetworkPlan plan) {
        this.svg = svg;
        this.graph = graph;
        this.plan = plan;
    }

    /**
     * The drawing of a network.
     *
     * @param labels names of its inputs and modules
     * @throws IllegalArgumentException if the number of labels is not that of the network's inputs or modules
     */
    public static String of(Genotype genotype, NetworkLabels labels) {
        NetworkGraph graph = NetworkGraph.of(genotype, labels);
        StringWriter text = new StringWriter();
        try {
            XMLStreamWriter svg = XMLOutputFactory.newDefaultFactory().createXMLStreamWriter(text);
            new NetworkSvg(svg, graph, NetworkPlan.of(graph)).draw();
            svg.close();
        } catch (XMLStreamException e) {
            throw new IllegalStateException("network " + genotype.id() + " cannot be drawn", e);
        }
        return text.append('\n').toString();
    }

    private void draw() throws XMLStreamException {
        svg.writeStartElement("svg");
        svg.writeDefaultNamespace("http://www.w3.org/2000/svg");
        attribute("viewBox", "0 0 " + number(plan.width()) + " " + number(plan.height()));
        attribute("width", number(plan.width()));
        attribute("height", number(plan.height()));
        attribute("font-family", "sans-serif");
        attribute("font-size", "11");
        title(graph.title());
        rectangle(0, 0, plan.width(), plan.height(), "white", "none");
        text(plan.width() / 2, 20, "middle", graph.title());
        drawModules();
        for (NetworkGraph.Link link : graph.links()) {
            draw(link);
        }
        for (int i = 0; i < graph.neurons().size(); i++) {
            drawNeuron(i);
        }
        drawLegend();
        svg.writeEndElement();
        svg.writeEndDocument();
    }

    private void drawModules() throws XMLStreamException {
        for (NetworkPlan.Box box : plan.modules()) {
            rectangle(box.left(), box.top(), box.width(), box.height(), "#f4f4f4", "#999999");
            text(
                    box.left() + box.width() / 2,
                    box.top() - 5,
                    "middle",
                    graph.modules().get(box.module()));
        }
    }

    private void draw(NetworkGraph.Link link) throws XMLStreamException {
        NetworkGraph.Neuron source = graph.neurons().get(link.source());
        NetworkGraph.Neuron target = graph.neurons().get(link.target());
        svg.writeStartElement("path");
        attribute("d", path(link));
        attribute("fill", "none");
        attribute("stroke", link.weight() < 0 ? NEGATIVE : POSITIVE);
        attribute("stroke-width", number(NetworkGraph.widthOf(link.weight())));
        attribute("stroke-opacity", "0.65");
        if (link.isRecurrent()) {
            attribute("stroke-dasharray", "4 2");
        }
        title(source.label() + " to " + target.label() + ", weight " + link.weight()
                + (link.isRecurrent() ? ", recurrent" : ""));
        svg.writeEndElement();
    }

    private String path(NetworkGraph.Link link) {
        double x1 = plan.x(link.source());
        double y1 = plan.y(link.source());
        double x2 = plan.x(link.target());
        double y2 = plan.y(link.target());
        if (link.source() == link.target()) {
            return "M " + point(x1 - 4, y1 - 7) + " C " + point(x1 - 16, y1 - 30) + " " + point(x1 + 16, y1 - 30) + " "
                    + point(x1 + 4, y1 - 7);
        }
        boolean isLevel = Math.abs(y1 - y2) < 1;
        if (!isLevel && !link.isRecurrent()) {
            return "M " + point(x1, y1) + " L " + point(x2, y2);
        }
        // Curved to one side in proportion to the distance, so that links in opposite directions do not overlap.
        double bow = isLevel ? 0.35 : 0.18;
        double controlX = (x1 + x2) / 2 + (y2 - y1) * bow;
        double controlY = (y1 + y2) / 2 - Math.abs(x2 - x1) * bow - (isLevel ? 12 : 0);
        return "M " + point(x1, y1) + " Q " + point(controlX, controlY) + " " + point(x2, y2);
    }

    private void drawNeuron(int position) throws XMLStreamException {
        NetworkGraph.Neuron neuron = graph.neurons().get(position);
        double x = plan.x(position);
        double y = plan.y(position);
        svg.writeStartElement("circle");
        attribute("cx", number(x));
        attribute("cy", number(y));
        attribute("r", number(RADIUS));
        attribute("fill", neuron.role() == NetworkGraph.Role.PREFERENCE ? "#a0a0a0" : "white");
        attribute("stroke", "black");
        title(neuron.label());
        svg.writeEndElement();
        if (neuron.role() == NetworkGraph.Role.INPUT) {
            svg.writeStartElement("text");
            attribute("transform", "translate(" + point(x + 4, y + 14) + ") rotate(-90)");
            attribute("text-anchor", "end");
            svg.writeCharacters(neuron.label());
            svg.writeEndElement();
        }
    }

    private void drawLegend() throws XMLStreamException {
        double y = plan.height() - 14;
        double x = NetworkPlan.MARGIN;
        x = legendLine(x, y, POSITIVE, false, "positive weight");
        x = legendLine(x, y, NEGATIVE, false, "negative weight");
        if (hasRecurrentLinks()) {
            x = legendLine(x, y, "black", true, "recurrent");
        }
        if (hasPreferenceNeurons()) {
            x = legendPreferenceNeuron(x, y);
        }
        text(x, y, "start", "width: size of the weight");
    }

    private boolean hasRecurrentLinks() {
        return graph.links().stream().anyMatch(NetworkGraph.Link::isRecurrent);
    }

    private boolean hasPreferenceNeurons() {
        return graph.neurons().stream().anyMatch(neuron -> neuron.role() == NetworkGraph.Role.PREFERENCE);
    }

    private double legendPreferenceNeuron(double x, double y) throws XMLStreamException {
        svg.writeStartElement("circle");
        attribute("cx", number(x + 6));
        attribute("cy", number(y - 4));
        attribute("r", "6");
        attribute("fill", "#a0a0a0");
        attribute("stroke", "black");
        svg.writeEndElement();
        text(x + 18, y, "start", "preference neuron");
        return x + 135;
    }

    private double legendLine(double x, double y, String colour, boolean isDashed, String meaning)
            throws XMLStreamException {
        svg.writeStartElement("path");
        attribute("d", "M " + point(x, y - 4) + " h 20");
        attribute("stroke", colour);
        attribute("stroke-width", "2.5");
        if (isDashed) {
            attribute("stroke-dasharray", "4 2");
        }
        svg.writeEndElement();
        text(x + 25, y, "start", meaning);
        return x + 30 + 6.2 * meaning.length();
    }

    private void rectangle(double x, double y, double width, double height, String fill, String stroke)
            throws XMLStreamException {
        svg.writeStartElement("rect");
        attribute("x", number(x));
        attribute("y", number(y));
        attribute("width", number(width));
        attribute("height", number(height));
        attribute("fill", fill);
        attribute("stroke", stroke);
        svg.writeEndElement();
    }

    private void text(double x, double y, String anchor, String text) throws XMLStreamException {
        svg.writeStartElement("text");
        attribute("x", number(x));
        attribute("y", number(y));
        attribute("text-anchor", anchor);
        svg.writeCharacters(text);
        svg.writeEndElement();
    }

    private void title(String text) throws XMLStreamException {
        svg.writeStartElement("title");
        svg.writeCharacters(text);
        svg.writeEndElement();
    }

    private void attribute(String name, String value) throws XMLStreamException {
        svg.writeAttribute(name, value);
    }

    private static String point(double x, double y) {
        return number(x) + " " + number(y);
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.1f", value);
    }
}
