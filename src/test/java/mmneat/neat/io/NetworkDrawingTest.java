package mmneat.neat.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import org.junit.jupiter.api.Test;

class NetworkDrawingTest {

    /** Two inputs, one hidden neuron, two modules; a self-link, a link back, a negative and an inactive link. */
    private static final Genotype NETWORK = network();

    private static final List<String> INPUTS = List.of("Distance to \"pill\"", "<bias> & more");
    private static final List<String> MODULES = List.of("ghosts", "a module with a name wider than its box");
    private static final NetworkLabels LABELS = new NetworkLabels(INPUTS, MODULES);

    private static Genotype network() {
        List<NodeGene> nodes = new ArrayList<>();
        for (long innovation : new long[] {-1, -2}) {
            nodes.add(new NodeGene(innovation, NodeType.INPUT, ActivationFunction.TANH));
        }
        nodes.add(new NodeGene(5, NodeType.HIDDEN, ActivationFunction.TANH));
        for (long innovation : new long[] {-3, -4, -5, -6}) {
            nodes.add(new NodeGene(innovation, NodeType.OUTPUT, ActivationFunction.TANH));
        }
        List<LinkGene> links = List.of(
                new LinkGene(0, -1, 5, 0.5, false),
                new LinkGene(1, 5, -3, -1.5, false),
                new LinkGene(2, -3, -3, 0.25, true),
                new LinkGene(3, -6, 5, 3, true),
                new LinkGene(4, -2, -5, 2, false).withActive(false),
                new LinkGene(6, -3, -6, 1, false));
        return new Genotype(9, 2, ModuleLayout.withPreferenceNeurons(2, 1), nodes, links, new int[] {1, 2});
    }

    private static Stream<XmlElement> descendants(XmlElement element) {
        return Stream.concat(Stream.of(element), element.children().stream().flatMap(NetworkDrawingTest::descendants));
    }

    @Test
    void svg_showsEveryNeuronAndActiveLink_inItsColour() throws IOException {
        XmlElement svg = XmlElement.parse(NetworkSvg.of(NETWORK, LABELS));

        List<XmlElement> links = descendants(svg)
                .filter(e -> e.name().equals("path") && !e.children().isEmpty())
                .toList();
        assertThat(links).hasSize(5);
        assertThat(links.stream().filter(e -> e.attributes().containsKey("stroke-dasharray")))
                .hasSize(2);
        assertThat(links.stream().filter(e -> e.attributes().get("stroke").equals("#ee6a4d")))
                .hasSize(1);
        List<XmlElement> neurons = descendants(svg)
                .filter(e -> e.name().equals("circle") && !e.children().isEmpty())
                .toList();
        assertThat(neurons).hasSize(7);
        assertThat(neurons.stream().filter(e -> e.attributes().get("fill").equals("#a0a0a0")))
                .hasSize(2);
    }

    @Test
    void svg_hasInputsBelow_andOutputsAbove() throws IOException {
        List<Double> heights = descendants(XmlElement.parse(NetworkSvg.of(NETWORK, NetworkLabels.NUMBERS)))
                .filter(e -> e.name().equals("circle") && !e.children().isEmpty())
                .map(e -> Double.valueOf(e.attributes().get("cy")))
                .toList();

        assertThat(heights.get(0)).isEqualTo(heights.get(1)).isGreaterThan(heights.get(2));
        assertThat(heights.get(2)).isGreaterThan(heights.get(3));
        assertThat(heights.subList(3, 7)).containsOnly(heights.get(3));
    }

    @Test
    void svg_escapesLabels() throws IOException {
        assertThat(descendants(XmlElement.parse(NetworkSvg.of(NETWORK, LABELS)))
                        .filter(e -> e.name().equals("text"))
                        .map(e -> e.text().toString()))
                .containsAll(INPUTS)
                .containsAll(MODULES);
    }

    @Test
    void svg_withoutNames_numbersInputsAndModules() throws IOException {
        assertThat(descendants(XmlElement.parse(NetworkSvg.of(NETWORK, NetworkLabels.NUMBERS)))
                        .filter(e -> e.name().equals("text"))
                        .map(e -> e.text().toString()))
                .contains("input 0", "input 1", "module 1", "module 2");
    }

    @Test
    void graphml_hasEveryNeuronAndActiveLink_withItsWeight() throws IOException {
        XmlElement graphml = XmlElement.parse(NetworkGraphml.of(NETWORK, LABELS));

        assertThat(descendants(graphml).filter(e -> e.name().equals("node"))).hasSize(7);
        assertThat(descendants(graphml)
                        .filter(e -> "weight".equals(e.attributes().get("key")))
                        .map(e -> e.text().toString()))
                .containsExactly("0.5", "-1.5", "0.25", "3.0", "1.0");
        assertThat(descendants(graphml).map(e -> e.text().toString())).containsAll(INPUTS);
    }

    @Test
    void dot_hasEveryNeuronAndActiveLink_andBalancedBrackets() {
        String dot = NetworkDot.of(NETWORK, LABELS);

        assertThat(dot.lines().filter(line -> line.contains(" -> "))).hasSize(5);
        assertThat(dot).contains("n0 [label=\"Distance to \\\"pill\\\"\", shape=box]", "n3 -> n3", "style=dashed");
        assertThat(dot.chars().filter(c -> c == '{').count())
                .isEqualTo(dot.chars().filter(c -> c == '}').count());
    }

    @Test
    void labels_ofAnotherNumber_areRefused() {
        assertThatThrownBy(() -> NetworkSvg.of(NETWORK, new NetworkLabels(List.of("one"), List.of())))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("1 labels for 2 inputs");
        assertThatThrownBy(() -> NetworkSvg.of(NETWORK, new NetworkLabels(INPUTS, INPUTS.subList(0, 1))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("1 labels for 2 modules");
    }

    @Test
    void missingLabels_areNamed() {
        assertThatThrownBy(() -> new NetworkLabels(null, MODULES)).hasMessage("inputs");
        assertThatThrownBy(() -> new NetworkLabels(INPUTS, null)).hasMessage("modules");
    }
}
